import { show } from './show.ts';

/** Vectors of any length but zero: normals to snap to, or the rows of a polyhedron's matrix. */
export type Directions = readonly (readonly [x: number, y: number, z: number])[];

/** True for a list of so many finite numbers. */
export function isPoint(value: unknown, size = 3): value is readonly number[] {
  return Array.isArray(value) && value.length === size && value.every((entry) => Number.isFinite(entry));
}

/** Whether an entry is a number of a range, both ends included. */
export function isWithin(min: number, max: number): (entry: unknown) => boolean {
  return (entry) => Number.isFinite(entry) && (entry as number) >= min && (entry as number) <= max;
}

/** What is wrong with a list that is to be {@link Directions}, as of `ValueKind.problem`. */
export function directionsProblem(value: readonly unknown[], what = 'directions'): string | undefined {
  const bad = value.findIndex((entry) => !isPoint(entry) || entry.every((part) => part === 0));
  if (value.length > 0 && bad < 0) return undefined;
  const found = bad < 0 ? 'it is empty' : `entry ${bad} is ${show(value[bad])}`;
  return `must list ${what} [x, y, z] of finite numbers, not all of them zero; ${found}.`;
}

/** What is wrong with a list that is to name vertices, as of `ValueKind.problem`. @param where such as “ of region 2” */
export function verticesProblem(vertices: readonly unknown[], where = ''): string | undefined {
  const bad = vertices.findIndex((vertex) => !Number.isInteger(vertex) || (vertex as number) < 0);
  if (bad < 0) return undefined;
  return `must name vertices by whole numbers from 0; entry ${bad}${where} is ${show(vertices[bad])}.`;
}
