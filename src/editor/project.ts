import type { Outcome, ReadResult } from '../engine/protocol.ts';
import type { FilesBeside, Format } from '../io/index.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import { movedMesh } from '../mesh/weld.ts';
import { findMethod } from '../methods/registry.ts';
import { type ParameterValues, takesNames } from '../methods/values/index.ts';
import type { Asset, Group, RecipeStep, StepRun } from '../recipe/index.ts';

/** The file as it came. */
export interface Source {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly name: string;
  /** Files that it refers to. */
  readonly beside?: FilesBeside;
  /** By the bytes: 'obj', 'glb', … */
  readonly format: Format;
  /** The normal map that it has inside. */
  readonly normalMap?: ReadResult['normalMap'];
  /** Where it was fetched from, as a link may lead there; a file of the person's own has none. */
  readonly address?: string;
}

/** The things that a project's steps name, by these names. */
export type Assets = ReadonlyMap<string, Asset>;

/** What a run of a step left, and what it was a run of. */
export interface Result {
  /** #P×3 in the file's frame and order. */
  readonly positions: Float64Array<ArrayBuffer>;
  /**
   * `settled` came from the step's rest shape and is what anyone else gets from the same file and recipe; `preview` followed
   * a moving slider and still has to be settled before it leaves the page; `stopped` is what a person chose to keep.
   */
  readonly state: 'settled' | 'preview' | 'stopped';
  readonly outcome: Outcome;
  readonly iterations: number;
  readonly energy: readonly number[];
  readonly milliseconds: number;
  /** Sentences about what was repaired or ignored, and what the images on the mesh are like. */
  readonly warnings: readonly string[];
  /** What the method tells besides the shape; for a settled result only. */
  readonly fields: StepRun['fields'];
  readonly of: StepInputs;
  /** The parameters as the engine took them: Gauss maps and slopes in place of names. */
  readonly resolved: ParameterValues;
}

/** All that a step's result depends on. */
export interface StepInputs {
  /** #P×3, the step's rest shape: the very array that the step before left. */
  readonly from: Float64Array<ArrayBuffer>;
  readonly method: string;
  readonly parameters: ParameterValues;
  /** The assets that the parameters name, in the order of the parameters. */
  readonly assets: readonly (Asset | undefined)[];
}

/** A step of the stack, in recipe form. */
export interface Step extends RecipeStep {
  /** Names the step: it stays whatever is changed of the step and wherever it is moved. */
  readonly id: number;
  /** A step that is switched off stays in the stack and does nothing. */
  readonly isOn: boolean;
  /** Values that a person set for other methods in this place, by method: a change of method loses none of them. */
  readonly remembered: Readonly<Record<string, ParameterValues>>;
  readonly result: Result | null;
}

/** All that undo brings back. Immutable: a change is a new project. The camera is not in it. */
export interface Project {
  readonly source: Source;
  readonly mesh: Mesh;
  readonly report: MeshReport;
  /** One step or more. */
  readonly steps: readonly Step[];
  /** The id of the step that is being edited. */
  readonly active: number;
  readonly assets: Assets;
  /** No two have the same name. */
  readonly groups: readonly Group[];
}

/** The step that is being edited. */
export function activeStep({ steps, active }: Project): Step {
  return steps.find(({ id }) => id === active) ?? steps[0]!;
}

export function findStep({ steps }: Project, id: number): Step | undefined {
  return steps.find((step) => step.id === id);
}

/** What a step depends on when it starts from these positions. */
export function inputsOf(
  { method, parameters }: RecipeStep,
  from: Float64Array<ArrayBuffer>,
  assets: Assets,
): StepInputs {
  const names = (findMethod(method)?.parameters ?? []).filter(takesNames).map(({ name }) => parameters[name]);
  const used = names.map((name) => (typeof name === 'string' ? assets.get(name) : undefined));
  return { from, method, parameters, assets: used };
}

export function sameInputs(a: StepInputs, b: StepInputs): boolean {
  const sameAssets = a.assets.every((asset, k) => asset === b.assets[k]);
  return (
    a.from === b.from && a.method === b.method && sameAssets && sameParameters(a.parameters, b.parameters)
  );
}

/** The inputs of the active step, as if nothing stood before it. */
export function activeInputs(project: Project): StepInputs {
  return inputsOf(activeStep(project), project.mesh.positions, project.assets);
}

/** Whether two projects have the same mesh and edit the same thing. */
export function sameActive(a: Project, b: Project): boolean {
  return (
    a.mesh === b.mesh &&
    a.groups === b.groups &&
    activeStep(a).isOn === activeStep(b).isOn &&
    sameInputs(activeInputs(a), activeInputs(b))
  );
}

export function sameParameters(a: ParameterValues, b: ParameterValues): boolean {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...names].every((name) => Object.is(a[name], b[name]));
}

/** A step that is on, with the shape that it gets. */
export interface PlacedStep {
  readonly step: Step;
  readonly inputs: StepInputs;
  /** The step has a result of these very inputs that may leave the page. */
  readonly isSettled: boolean;
}

/**
 * The steps that are on, each on what the one before left, up to and including the first that has nothing to hand on: no result, or
 * one of another rest shape.
 */
export function placedSteps({ mesh, steps, assets }: Project): readonly PlacedStep[] {
  const placed: PlacedStep[] = [];
  let from = mesh.positions;
  for (const step of steps) {
    if (!step.isOn) continue;
    const inputs = inputsOf(step, from, assets);
    const { result } = step;
    const isSettled = result !== null && result.state !== 'preview' && sameInputs(result.of, inputs);
    placed.push({ step, inputs, isSettled });
    if (result?.of.from !== from) break;
    from = result.positions;
  }
  return placed;
}

/** The first step whose result is missing, or is of other inputs than it has now; undefined if the stack is settled. */
export function firstUnsettled(project: Project): PlacedStep | undefined {
  return placedSteps(project).find(({ isSettled }) => !isSettled);
}

/** The rest shape of a step that is on; null while a step before it has nothing to hand on. */
export function restShapeOf(project: Project, id: number): Float64Array<ArrayBuffer> | null {
  return placedSteps(project).find(({ step }) => step.id === id)?.inputs.from ?? null;
}

/** What is to be seen of a project, #P×3: as far as its steps have results that follow from each other. */
export function shownPositions(project: Project): Float64Array<ArrayBuffer> {
  const last = placedSteps(project).at(-1);
  if (!last) return project.mesh.positions;
  const { step, inputs } = last;
  return step.result?.of.from === inputs.from ? step.result.positions : inputs.from;
}

/** The result that is on the screen; null where that is the file's own shape. */
export function shownResult(project: Project): Result | null {
  const shown = shownPositions(project);
  return project.steps.find(({ isOn, result }) => isOn && result?.positions === shown)?.result ?? null;
}

const meshes = new WeakMap<Mesh, WeakMap<Float64Array, Mesh>>();

/** The project's mesh in the shape that a step left; the same object at every asking, so that the engine knows it. */
export function meshAt({ mesh }: Pick<Project, 'mesh'>, positions: Float64Array<ArrayBuffer>): Mesh {
  if (positions === mesh.positions) return mesh;
  const known = meshes.get(mesh) ?? new WeakMap<Float64Array, Mesh>();
  meshes.set(mesh, known);
  const moved = known.get(positions) ?? movedMesh(mesh, positions);
  known.set(positions, moved);
  return moved;
}

export function resultOf(run: StepRun, state: Result['state'], of: StepInputs): Result {
  const { positions, outcome, iterations, energy, milliseconds, warnings, fields, resolved } = run;
  const { prepare, solve } = milliseconds;
  const both = prepare + solve;
  return {
    positions,
    state,
    outcome,
    iterations,
    energy,
    milliseconds: both,
    warnings,
    fields,
    of,
    resolved,
  };
}
