import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import type { TestMesh } from '../fixtures/subdivision.ts';

/** A round part whose size is to stay: the vertices on it, and the axis of a cylinder; a ball has none. */
export interface Round {
  readonly name: string;
  readonly vertices: readonly number[];
  readonly axis?: Vec3;
}

/** A mesh that was made here, with names for its parts: gestures and measures need not guess. */
export interface Shape extends TestMesh {
  readonly name: string;
  /** Vertices by name; `left` and `right`, `front` and `back`, `bottom` and `top` are ends in x, y and z where those are flat. */
  readonly sets: Readonly<Record<string, readonly number[]>>;
  readonly rounds: readonly Round[];
  /** Names of the sets that are bevels: narrow, and to stay as wide as they are. */
  readonly bevels: readonly string[];
}

/** Vertices of a part of a shape. */
export function part({ name, sets }: Shape, of: string): readonly number[] {
  const found = sets[of];
  if (!found?.length)
    throw new Error(`“${name}” has no part “${of}”; it has ${Object.keys(sets).join(', ')}.`);
  return found;
}

/** Rows of a rotation. */
export type Rotation = readonly [Vec3, Vec3, Vec3];

/** The rotation about an axis, right-handed, in degrees. */
export function rotation([x, y, z]: Vec3, degrees: number): Rotation {
  const size = Math.hypot(x, y, z);
  const [a, b, c] = [x / size, y / size, z / size];
  const [s, k] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  const m = 1 - k;
  return [
    [k + a * a * m, a * b * m - c * s, a * c * m + b * s],
    [a * b * m + c * s, k + b * b * m, b * c * m - a * s],
    [a * c * m - b * s, b * c * m + a * s, k + c * c * m],
  ];
}

/** Oblique to every axis. */
export const oblique = rotation([1, 2, 3], 37);

export const turnedPoint = ([x, y, z]: Vec3, by: Rotation): Vec3 =>
  by.map(([a, b, c]) => a * x + b * y + c * z) as unknown as Vec3;

/** A shape that lies otherwise in space. */
export function turned<S extends Shape>(shape: S, by: Rotation): S {
  const positions = new Float64Array(shape.positions.length);
  for (let v = 0; 3 * v < positions.length; v++)
    positions.set(turnedPoint(row(shape.positions, v), by), 3 * v);
  const rounds = shape.rounds.map((round) =>
    round.axis ? { ...round, axis: turnedPoint(round.axis, by) } : round,
  );
  return { ...shape, positions, rounds };
}

/** Several shapes as one mesh, of which each is a part; names of parts, sets and rounds get that of their shape before them. */
export function assembled(name: string, shapes: Readonly<Record<string, Shape>>): Shape {
  const positions: number[] = [];
  const triangles: number[] = [];
  const sets: Record<string, readonly number[]> = {};
  const rounds: Round[] = [];
  const bevels: string[] = [];
  for (const [title, shape] of Object.entries(shapes)) {
    const first = positions.length / 3;
    const later = (vertices: readonly number[]) => vertices.map((v) => first + v);
    for (const value of shape.positions) positions.push(value);
    for (const v of shape.triangles) triangles.push(first + v);
    for (const [set, vertices] of Object.entries(shape.sets)) sets[`${title} ${set}`] = later(vertices);
    for (const round of shape.rounds) {
      rounds.push({ ...round, name: `${title} ${round.name}`, vertices: later(round.vertices) });
    }
    bevels.push(...shape.bevels.map((bevel) => `${title} ${bevel}`));
  }
  return {
    name,
    positions: Float64Array.from(positions),
    triangles: Uint32Array.from(triangles),
    sets,
    rounds,
    bevels,
  };
}
