import { WhittleError } from '../../mesh/failure.ts';
import type { Encoded, Parameter, ValueKind } from './parameter.ts';
import { isPoint, verticesProblem } from './points.ts';
import { show } from './show.ts';

/** A plane normal·x = offset in the file's own units, and vertices (indices of the source file's position list) that stay on it. */
export interface Plane {
  readonly vertices: readonly number[];
  /** Of any length but zero. */
  readonly normal: readonly [number, number, number];
  readonly offset: number;
}

/** A vertex may be on several: on two it is held on a line, on three in a point. */
export type Planes = readonly Plane[];

/** Vertices held on planes: {@link Planes}. Absent or empty means none. */
export interface PlanesParameter extends Parameter {
  readonly kind: 'planes';
}

export const planes: ValueKind<PlanesParameter, Planes> = {
  code: 'bad-planes',
  problem(_, value) {
    const shape = 'must be [{"vertices": [index, …], "normal": [x, y, z], "offset": number}, …]';
    if (!Array.isArray(value)) return `${shape}, not ${show(value)}.`;
    for (const [index, plane] of value.entries()) {
      const { vertices, normal, offset, ...rest } = (plane ?? {}) as Partial<Record<string, unknown>>;
      if (!Array.isArray(vertices)) return `${shape}; plane ${index} has no list of vertices.`;
      const [stranger] = Object.keys(rest);
      if (stranger !== undefined) return `${shape}; plane ${index} has an entry “${stranger}” too many.`;
      const what = verticesProblem(vertices, ` of plane ${index}`);
      if (what !== undefined) return what;
      if (!isPoint(normal) || normal.every((entry) => entry === 0))
        return `must have as normal three finite numbers, not all of them zero; that of plane ${index} is ${show(normal)}.`;
      if (!Number.isFinite(offset))
        return `must have as offset a finite number; that of plane ${index} is ${show(offset)}.`;
    }
    return undefined;
  },
  /** A place that the file stores several times is on a plane once. */
  encode({ name }, all, { vertexOfPosition }): Encoded {
    const count = vertexOfPosition.length;
    const indices: number[] = [];
    for (const [plane, { vertices }] of all.entries()) {
      const held = new Set<number>();
      for (const source of vertices) {
        const vertex = vertexOfPosition[source];
        if (vertex === undefined) {
          throw new WhittleError(
            'bad-planes',
            `“${name}” names vertex ${source} in plane ${plane}, but the file has ${count} vertices (0 to ${count - 1}).`,
            source,
          );
        }
        held.add(vertex);
      }
      indices.push(held.size);
      for (const vertex of held) indices.push(vertex);
    }
    const numbers = all.flatMap(({ normal, offset }) => [...normal, offset]);
    return { name: '', numbers: Float64Array.from(numbers), indices: Uint32Array.from(indices) };
  },
  help: () => ({
    value: 'FILE.json',
    range: '[{"vertices": [0, …], "normal": [x, y, z], "offset": number}, …], default none',
  }),
};
