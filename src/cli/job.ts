import type { Engine } from '../engine/client.ts';
import { gatherBeside } from '../engine/gather.ts';
import { formatForFileName, isFormat } from '../io/index.ts';
import { at } from '../mesh/failure.ts';
import { type RecipeStep, runRecipe } from '../recipe/index.ts';
import type { RunFiles } from './command.ts';
import { requireFolderOf, writeWhole } from './files.ts';
import { UsageError } from './problems.ts';
import type { ProgressLine } from './progress.ts';
import { inputReport, type RunReport, stepReport } from './report.ts';
import { meshOf, type Work } from './work.ts';

export interface Job extends Work {
  readonly files: RunFiles;
  readonly progress: ProgressLine;
  /** Aborts: before the first iteration the job rejects with the reason, later it keeps what it has. */
  readonly signal: AbortSignal;
}

/**
 * Reads, runs all steps and writes the result and the report. Nothing is written unless all of it went well.
 *
 * @throws UsageError, FileError, WhittleError; their messages begin with the file
 */
export async function runJob(engine: Engine, job: Job): Promise<RunReport> {
  const { steps, readFile, files, progress, signal } = job;
  const { out } = files;
  requireFormat(out);
  for (const path of [out, files.report]) if (path !== undefined) await requireFolderOf(path);

  progress.show(`reading ${files.input}`);
  const reading = stopwatch();
  const { name: input, bytes: source, read } = job.mesh ?? (await meshOf(files.input));
  const beside = await gatherBeside(engine, source, input, { read });
  const { format, warnings, ...surface } = await engine.read(source, input, { signal, beside });
  const readMilliseconds = reading();

  const name = ({ method }: RecipeStep, index: number) =>
    steps.length === 1 ? method : `step ${index + 1}: ${method}`;
  const run = await runRecipe(
    engine,
    surface,
    { steps },
    {
      signal,
      name: input,
      surroundings: { readFile },
      onStep: (step, index) => progress.follow(name(step, index)),
    },
  );
  const reports = run.steps.map(stepReport);
  reports[0]!.milliseconds.read = readMilliseconds;
  reports[0]!.warnings.unshift(...warnings);

  progress.show(`writing ${out}`);
  const writing = stopwatch();
  const outFormat = formatForFileName(out, isFormat(format) ? format : undefined);
  const { positions } = run.mesh;
  const written = await at(out, engine.write(source, input, outFormat, positions, { beside }));
  await writeWhole(out, written.bytes);
  reports.at(-1)!.milliseconds.write = writing();
  reports.at(-1)!.warnings.push(...written.warnings);

  const report = { input: inputReport(run.input), steps: reports };
  if (files.report !== undefined) await writeWhole(files.report, `${JSON.stringify(report, null, 2)}\n`);
  return report;
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
