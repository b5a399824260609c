import type { Engine, ProgressListener } from '../engine/client.ts';
import type { Outcome, Solved, Start } from '../engine/protocol.ts';
import { at } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import { movedMesh } from '../mesh/weld.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import type { Recipe, RecipeStep } from './recipe.ts';
import { Resolver, type Surroundings, type TexturedMesh } from './resolve.ts';

/** A field of a method, and its numbers: #P in the file's order, or #F, or for lines #×2 positions. */
export type FieldValues = Solved['fields'][number] & { readonly values: Float64Array<ArrayBuffer> };

/** One step of a recipe, done. */
export interface StepRun {
  readonly method: string;
  readonly outcome: Outcome;
  readonly iterations: number;
  /** Per iteration, in the unit frame. */
  readonly energy: readonly number[];
  /** Reading styles and images, welding and validating are preparation too. */
  readonly milliseconds: { readonly prepare: number; readonly solve: number };
  readonly warnings: readonly string[];
  /** What the method tells besides the shape, where that was asked for. */
  readonly fields: readonly FieldValues[];
  /** The values as the engine took them: Gauss maps and slopes in place of names. */
  readonly resolved: ParameterValues;
  /** #P×3 in the file's frame and order: the rest shape of the next step. */
  readonly positions: Float64Array<ArrayBuffer>;
}

export interface StepOptions {
  /** When it aborts, the step ends as `cancelled` with what it has. */
  readonly signal?: AbortSignal | undefined;
  /** Where the run begins; default at the mesh's own shape. */
  readonly start?: Start;
  /** Whether progress carries positions. Default false. */
  readonly positions?: boolean;
  readonly onProgress?: ProgressListener | undefined;
  /** Called when the step's names have been read, before the engine is asked; what it throws ends the step. */
  readonly onResolved?: () => void;
  /** Whether the method's fields are wanted. Default false. */
  readonly fields?: boolean;
  /** What sentences about the mesh begin with; default nothing. */
  readonly place?: string;
}

/**
 * Runs one step on a mesh, whose shape is its rest shape.
 *
 * @throws WhittleError as the step's names, its values or the mesh are refused, or as it failed
 */
export async function runStep(
  engine: Engine,
  resolver: Resolver,
  surface: TexturedMesh,
  step: RecipeStep,
  options: StepOptions = {},
): Promise<StepRun> {
  const { signal, start = 'rest', positions = false, onProgress, fields = false, place = '' } = options;
  const reading = stopwatch();
  const { method, parameters, warnings } = await resolver.resolve(step, surface, place);
  options.onResolved?.();
  const read = reading();
  const settings = { method, parameters, start, positions };
  const { milliseconds, ...solved } = await at(
    place,
    engine.solve(surface.mesh, settings, { signal, onProgress }),
  );
  const told = fields ? await fieldsOf(engine, surface.mesh, solved) : [];
  return {
    ...solved,
    method,
    fields: told,
    resolved: parameters,
    milliseconds: { prepare: read + milliseconds.prepare, solve: milliseconds.solve },
    warnings: [...solved.warnings, ...warnings],
  };
}

function fieldsOf(
  engine: Engine,
  mesh: Mesh,
  { fields }: Pick<Solved, 'fields'>,
): Promise<readonly FieldValues[]> {
  return Promise.all(
    fields.map(async (field) => ({ ...field, values: await engine.field(mesh, field.name) })),
  );
}

/** All that became of a recipe on a mesh. */
export interface RecipeRun {
  /** The mesh as the last step left it. */
  readonly mesh: Mesh;
  /** What the core says of the mesh that the first step got. */
  readonly input: MeshReport;
  /** Those that ran: one that was cancelled is the last. */
  readonly steps: readonly StepRun[];
}

export interface RunOptions {
  /** When it aborts before the first step is solved, the run rejects with the reason; later it keeps what it has. */
  readonly signal?: AbortSignal | undefined;
  /** Whether progress carries positions. Default false. */
  readonly positions?: boolean;
  /** Called when a step begins; answers what is to see its progress. */
  readonly onStep?: (step: RecipeStep, index: number) => ProgressListener | undefined;
  /** Where the names in the recipe lead: files, assets. Default: names of ours only. */
  readonly surroundings?: Surroundings;
  /** What the mesh is called in sentences about it; default: nothing is put before them. */
  readonly name?: string;
}

/**
 * Runs the steps of a recipe one after the other: each gets as its rest shape what the one before left. The one runner of command
 * line, page and element.
 *
 * @throws WhittleError as a step's names, its values or the mesh are refused, or as it failed; the sentence begins with `name` and,
 *   where there are several steps, says which
 */
export async function runRecipe(
  engine: Engine,
  surface: TexturedMesh,
  { steps }: Recipe,
  { signal, positions = false, onStep, surroundings, name = '' }: RunOptions = {},
): Promise<RecipeRun> {
  const resolver = new Resolver(engine, surroundings);
  const input = await at(name, engine.inspect(surface.mesh, { signal }));
  const runs: StepRun[] = [];
  let { mesh } = surface;
  for (const [index, step] of steps.entries()) {
    const place = steps.length === 1 ? name : `${name && `${name}, `}step ${index + 1} (${step.method})`;
    const onProgress = onStep?.(step, index);
    const loading = stopwatch();
    await at(place, engine.inspect(mesh));
    const loaded = loading();
    const run = await runStep(engine, resolver, { ...surface, mesh }, step, {
      signal,
      positions,
      onProgress,
      place,
    });
    engine.release(mesh);
    const { prepare, solve } = run.milliseconds;
    runs.push({ ...run, milliseconds: { prepare: loaded + prepare, solve } });
    mesh = movedMesh(mesh, run.positions);
    if (run.outcome === 'cancelled') break;
  }
  return { mesh, input, steps: runs };
}

/** Milliseconds since this call. */
function stopwatch(): () => number {
  const began = performance.now();
  return () => performance.now() - began;
}
