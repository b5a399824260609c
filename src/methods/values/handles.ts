import { WhittleError } from '../../mesh/failure.ts';
import { distance, subtract, type Vec3 } from '../../mesh/vectors.ts';
import { offsetOf } from '../../mesh/weld.ts';
import type { Parameter, ValueKind } from './parameter.ts';
import { isPoint, verticesProblem } from './points.ts';
import { show } from './show.ts';

/** Vertices (indices of the source file's position list) and where they are to go, in the file's own units. */
export interface Handles {
  readonly vertices: readonly number[];
  readonly targets: readonly (readonly [number, number, number])[];
  /** More vertices, which stay where they are: the same as their own places for targets. */
  readonly fixed?: readonly number[];
}

/** Vertices held at given places: {@link Handles}. Absent means none. */
export interface HandlesParameter extends Parameter {
  readonly kind: 'handles';
  /** What a hand takes hold of best: a whole side, edge or rim of the shape. Default: a spot. */
  readonly grip?: 'side';
}

export const handles: ValueKind<HandlesParameter, Handles> = {
  code: 'bad-handles',
  problem(_, value) {
    const shape =
      'must be {"vertices": [index, …], "targets": [[x, y, z], …]}, and may have {"fixed": [index, …]}';
    if (typeof value !== 'object' || value === null || Array.isArray(value))
      return `${shape}, not ${show(value)}.`;
    const { vertices, targets, fixed = [], ...rest } = value as Record<keyof Handles, unknown>;
    if (!Array.isArray(vertices) || !Array.isArray(targets)) return `${shape}; both lists are needed.`;
    if (!Array.isArray(fixed)) return `${shape}, not ${show(fixed)}.`;
    const [stranger] = Object.keys(rest);
    if (stranger !== undefined) return `${shape}; it has an entry “${stranger}” too many.`;
    if (vertices.length !== targets.length) {
      return `must have as many targets as vertices; there are ${vertices.length} vertices and ${targets.length} targets.`;
    }
    const badVertices = verticesProblem(vertices) ?? verticesProblem(fixed, ' of “fixed”');
    if (badVertices !== undefined) return badVertices;
    const bad = targets.findIndex((target) => !isPoint(target));
    if (bad < 0) return undefined;
    return `must have targets [x, y, z] of finite numbers; entry ${bad} is ${show(targets[bad])}.`;
  },
  /**
   * Handles that say the same of the same place become one; positions that the file stores twice can only move together. Where
   * these differ by rounding, their targets may differ by as much.
   */
  encode({ name }, { vertices, targets, fixed = [] }, weld) {
    const handles = new Map<number, Handle>();
    const count = weld.vertexOfPosition.length;
    const vertexOf = (source: number) => {
      const vertex = weld.vertexOfPosition[source];
      if (vertex !== undefined) return vertex;
      throw new WhittleError(
        'bad-handles',
        `“${name}” names vertex ${source}, but the file has ${count} vertices (0 to ${count - 1}).`,
        source,
      );
    };
    vertices.forEach((source, entry) => {
      const vertex = vertexOf(source);
      const handle = { source, offset: offsetOf(weld, source), target: targets[entry]! };
      const earlier = handles.get(vertex);
      if (!earlier) handles.set(vertex, handle);
      else if (!agree(earlier, handle)) throw twoTargets(name, earlier.source, source);
    });
    // Those that stay come last, without numbers.
    const staying = new Map(fixed.map((source) => [vertexOf(source), source]));
    for (const [vertex, source] of staying) {
      const moved = handles.get(vertex);
      if (moved) throw movedAndFixed(name, moved.source, source);
    }
    const held = [...handles.values()].map(({ target, offset }) => subtract(target, offset));
    const indices = Uint32Array.from([...handles.keys(), ...staying.keys()]);
    return { name: '', numbers: Float64Array.from(held.flat()), indices };
  },
  help: () => ({
    value: 'FILE.json',
    range: '{"vertices": [0, …], "targets": [[x, y, z], …], "fixed": [1, …]}, default none',
  }),
};

function twoTargets(name: string, first: number, second: number): WhittleError {
  const message =
    first === second
      ? `“${name}” gives vertex ${second} two different targets; keep one.`
      : `“${name}” gives vertices ${first} and ${second} different targets, but they are the same point of the surface ` +
        '(the file stores it twice, along a seam); give both the same target or keep one.';
  return new WhittleError('bad-handles', message, second);
}

function movedAndFixed(name: string, moved: number, fixed: number): WhittleError {
  const message =
    moved === fixed
      ? `“${name}” gives vertex ${fixed} a target and has it under “fixed” too; keep one.`
      : `“${name}” gives vertex ${moved} a target and has vertex ${fixed} under “fixed”, but they are the same point of the ` +
        'surface (the file stores it twice, along a seam); keep one.';
  return new WhittleError('bad-handles', message, fixed);
}

interface Handle {
  readonly source: number;
  /** From the place of the vertex. */
  readonly offset: Vec3;
  readonly target: Vec3;
}

/** Whether two positions of one vertex are drawn to one place, give or take what lies between them. */
function agree(a: Handle, b: Handle): boolean {
  return distance(a.target, b.target) <= 2 * distance(a.offset, b.offset);
}
