import type { Engine } from '../engine/client.ts';
import { formatForFileName, isFormat } from '../io/index.ts';
import { movedMesh } from '../mesh/weld.ts';
import type { RecipeStep } from '../recipe/index.ts';
import type { RunFiles } from './command.ts';
import { readBytes, requireFolderOf, writeWhole } from './files.ts';
import { at, UsageError } from './problems.ts';
import type { Progress } from './progress.ts';
import { type TexturedSurface, withRelief } from './relief.ts';
import { inputReport, type RunReport, type StepReport, stepReport } from './report.ts';
import { withStyle } from './style.ts';

export interface Job {
  readonly steps: readonly RecipeStep[];
  /** The recipe's file, if there is one: the styles and pictures that it names lie beside it. */
  readonly recipe?: string | undefined;
  readonly files: RunFiles;
  readonly progress: Progress;
  /** Aborts: before the first iteration the job rejects with the reason, later it keeps what it has. */
  readonly signal: AbortSignal;
}

/**
 * Reads, runs all steps and writes the result and the report. Nothing is written unless all of it went well.
 *
 * @throws UsageError, FileError, WhittleError; their messages begin with the file
 */
export async function runJob(engine: Engine, job: Job): Promise<RunReport> {
  const { files, progress, signal } = job;
  const { input, out } = files;
  requireFormat(out);
  for (const path of [out, files.report]) if (path !== undefined) await requireFolderOf(path);

  progress.show(`reading ${input}`);
  const reading = stopwatch();
  const source = await readBytes(input);
  const { mesh, format, warnings, normalMap } = await engine.read(source, input, { signal });
  const readMilliseconds = reading();

  const result = await runSteps(engine, { mesh, normalMap }, job);
  result.reports[0]!.milliseconds.read = readMilliseconds;
  result.reports[0]!.warnings.unshift(...warnings);

  progress.show(`writing ${out}`);
  const writing = stopwatch();
  const outFormat = formatForFileName(out, isFormat(format) ? format : undefined);
  const bytes = await at(out, engine.write(source, input, outFormat, result.positions));
  await writeWhole(out, bytes);
  result.reports.at(-1)!.milliseconds.write = writing();

  const report = { input: result.input, steps: result.reports };
  if (files.report !== undefined) await writeWhole(files.report, `${JSON.stringify(report, null, 2)}\n`);
  return report;
}

interface StepsResult {
  readonly positions: Float64Array<ArrayBuffer>;
  readonly input: RunReport['input'];
  readonly reports: StepReport[];
}

/** Each step's result is the next one's rest shape. A step that was cancelled is the last. */
async function runSteps(
  engine: Engine,
  { mesh, normalMap }: TexturedSurface,
  job: Job,
): Promise<StepsResult> {
  const { steps, files, progress, signal } = job;
  const reports: StepReport[] = [];
  let current = mesh;
  let input: RunReport['input'] | undefined;
  for (const [index, step] of steps.entries()) {
    const { method } = step;
    const place = steps.length === 1 ? files.input : `${files.input}, step ${index + 1} (${method})`;
    const onFrame = progress.follow(steps.length === 1 ? method : `step ${index + 1}: ${method}`);
    const loading = stopwatch();
    const styled = await withStyle(engine, step, job.recipe);
    const surface = { mesh: current, normalMap };
    const { parameters, warnings } = await withRelief(
      surface,
      place,
      { method, parameters: styled },
      job.recipe,
    );
    const meshReport = await at(place, engine.inspect(current, index === 0 ? { signal } : {}));
    const loadMilliseconds = loading();
    input ??= inputReport(meshReport);

    const settings = { method, parameters, start: 'rest', frames: false } as const;
    const solved = await at(place, engine.solve(current, settings, { signal, onFrame }));
    engine.release(current);
    reports.push(stepReport(method, solved, loadMilliseconds));
    reports.at(-1)!.warnings.push(...warnings);
    current = movedMesh(current, solved.positions);
    if (solved.outcome === 'cancelled') break;
  }
  return { positions: current.positions, input: input!, reports };
}

/** A wrong ending should not be found out after a long run. */
function requireFormat(out: string): void {
  try {
    formatForFileName(out);
  } catch (thrown) {
    throw new UsageError(`--out ${(thrown as Error).message}`);
  }
}

/** Milliseconds since this call. */
function stopwatch(): () => number {
  const began = performance.now();
  return () => performance.now() - began;
}
