import type { ParameterValue, ParameterValues } from '../methods/values/index.ts';
import { findStep, type Project, type Result, type Step } from './project.ts';

/**
 * A project that undo keeps in little room: long lists as what differs from a neighbour in time, shapes to a 65 000th of their
 * largest move. An undone shape is seen at once and is settled before it leaves the page, as any preview is.
 */
export interface PackedProject {
  /** All of it but what is packed. */
  readonly rest: Project;
  readonly steps: readonly PackedStep[];
}

interface PackedStep {
  readonly parameters: ReadonlyMap<string, Difference>;
  readonly result: PackedResult | null;
}

/** A list against the one of the same step and name in the neighbour. */
interface Difference {
  readonly places: Uint32Array<ArrayBuffer>;
  readonly values: Float64Array<ArrayBuffer>;
  /** As it was a list of numbers and no typed array. */
  readonly isPlain: boolean;
}

interface PackedResult {
  /** Without positions; `of.from` is that of the file, or else what the step before left. */
  readonly rest: Omit<Result, 'positions'>;
  readonly startsFrom: 'file' | 'before';
  /** Steps of `unit` from where it started, #P×3. */
  readonly moves: Int16Array<ArrayBuffer>;
  readonly unit: number;
}

/** Shorter lists are not worth it. */
const shortest = 1000;
const mostSteps = 32767;

/** @param neighbour the project next to it in time, from which it is unpacked again */
export function pack(project: Project, neighbour: Project): PackedProject {
  const steps: PackedStep[] = [];
  const kept: Step[] = [];
  let left: Float64Array | null = null;
  for (const step of project.steps) {
    const parameters = differencesOf(step, findStep(neighbour, step.id));
    const result: PackedResult | null = packResult(step, project, left);
    left = step.result?.positions ?? left;
    steps.push({ parameters, result });
    kept.push({
      ...step,
      parameters: without(step.parameters, parameters),
      result: result ? null : step.result,
    });
  }
  return { rest: { ...project, steps: kept }, steps };
}

/** @param neighbour the very project that it was packed against, or one with the same lists */
export function unpack({ rest, steps }: PackedProject, neighbour: Project): Project {
  let left = rest.mesh.positions;
  const unpacked = rest.steps.map((step, k): Step => {
    const { parameters: differences, result: packed } = steps[k]!;
    const parameters = restored(step.parameters, differences, findStep(neighbour, step.id));
    const result = packed ? unpackResult(packed, parameters, rest, left) : step.result;
    left = result?.positions ?? left;
    return { ...step, parameters, result };
  });
  return { ...rest, steps: unpacked };
}

function packResult(
  { parameters, result }: Step,
  { mesh }: Project,
  left: Float64Array | null,
): PackedResult | null {
  if (!result || result.positions.length < shortest) return null;
  const { positions, ...others } = result;
  const { from } = others.of;
  const startsFrom = from === mesh.positions ? 'file' : from === left ? 'before' : null;
  if (!startsFrom) return null;
  let largest = 0;
  for (let i = 0; i < positions.length; i++)
    largest = Math.max(largest, Math.abs(positions[i]! - from[i]!) || 0);
  const unit = largest / mostSteps || 1;
  const moves = new Int16Array(positions.length);
  for (let i = 0; i < moves.length; i++) moves[i] = Math.round((positions[i]! - from[i]!) / unit);
  const isOwn = ([name, value]: [string, ParameterValue]) => !isLong(value) || parameters[name] !== value;
  const resolved = Object.fromEntries(Object.entries(others.resolved).filter(isOwn));
  const of = { ...others.of, from: mesh.positions, parameters: {} };
  // Fields tell of a settled result only.
  return { rest: { ...others, of, resolved, fields: [] }, startsFrom, moves, unit };
}

function unpackResult(
  { rest, startsFrom, moves, unit }: PackedResult,
  parameters: ParameterValues,
  { mesh }: Project,
  left: Float64Array<ArrayBuffer>,
): Result {
  const from = startsFrom === 'file' ? mesh.positions : left;
  const positions = new Float64Array(moves.length);
  for (let i = 0; i < positions.length; i++) positions[i] = from[i]! + unit * moves[i]!;
  return {
    ...rest,
    positions,
    state: rest.state === 'stopped' ? 'stopped' : 'preview',
    of: { ...rest.of, from, parameters },
    resolved: { ...parameters, ...rest.resolved },
  };
}

function differencesOf({ method, parameters }: Step, other: Step | undefined): Map<string, Difference> {
  const found = new Map<string, Difference>();
  if (other?.method !== method) return found;
  for (const [name, value] of Object.entries(parameters)) {
    const base = other.parameters[name];
    if (isLong(value) && isLong(base) && base.length === value.length) {
      const difference = differenceOf(value, base);
      if (difference) found.set(name, difference);
    }
  }
  return found;
}

/** Null where more than a third is other: then the list itself is shorter. */
function differenceOf(list: LongList, base: LongList): Difference | null {
  const places: number[] = [];
  for (let i = 0; i < list.length; i++) {
    if (Object.is(list[i], base[i])) continue;
    places.push(i);
    if (3 * places.length > list.length) return null;
  }
  return {
    places: Uint32Array.from(places),
    values: Float64Array.from(places, (place) => list[place]!),
    isPlain: Array.isArray(list),
  };
}

function restored(
  parameters: ParameterValues,
  differences: ReadonlyMap<string, Difference>,
  other: Step | undefined,
): ParameterValues {
  if (differences.size === 0) return parameters;
  const lists = [...differences].map(([name, { places, values, isPlain }]) => {
    const list = Float64Array.from(other!.parameters[name] as LongList);
    places.forEach((place, k) => {
      list[place] = values[k]!;
    });
    return [name, isPlain ? [...list] : list] as const;
  });
  return { ...parameters, ...Object.fromEntries(lists) };
}

function without(parameters: ParameterValues, gone: ReadonlyMap<string, unknown>): ParameterValues {
  return Object.fromEntries(Object.entries(parameters).filter(([name]) => !gone.has(name)));
}

type LongList = readonly number[] | Float64Array;

function isLong(value: ParameterValue | undefined): value is LongList {
  const isList = value instanceof Float64Array || (Array.isArray(value) && typeof value[0] === 'number');
  return isList && (value as LongList).length >= shortest;
}
