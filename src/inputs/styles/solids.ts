import { between, distance, type Vec3 } from '../../mesh/vectors.ts';

/** Corners of convex solids; their faces are what the convex hull makes of them. The axis of anything round is y. */

const golden = (1 + Math.sqrt(5)) / 2;

/** Every sign of every coordinate that is not zero. */
function signed([x, y, z]: Vec3): Vec3[] {
  const signs = (value: number): number[] => (value === 0 ? [0] : [value, -value]);
  return signs(x).flatMap((a) => signs(y).flatMap((b) => signs(z).map((c): Vec3 => [a, b, c])));
}

const cyclic = ([x, y, z]: Vec3): Vec3[] => [
  [x, y, z],
  [y, z, x],
  [z, x, y],
];

export const tetrahedron: readonly Vec3[] = [
  [1, 1, 1],
  [1, -1, -1],
  [-1, 1, -1],
  [-1, -1, 1],
];
export const cube: readonly Vec3[] = signed([1, 1, 1]);
export const octahedron: readonly Vec3[] = cyclic([1, 0, 0]).flatMap(signed);
export const icosahedron: readonly Vec3[] = cyclic([0, 1, golden]).flatMap(signed);
export const dodecahedron: readonly Vec3[] = [...cube, ...cyclic([0, 1 / golden, golden]).flatMap(signed)];

/** Cuts every corner of a solid whose edges are equally long and its shortest distances, at a share of each edge. */
export function truncated(corners: readonly Vec3[], share: number): Vec3[] {
  const pairs = corners.flatMap((a) => corners.filter((b) => b !== a).map((b) => [a, b] as const));
  const edge = Math.min(...pairs.map(([a, b]) => distance(a, b)));
  return pairs.filter(([a, b]) => distance(a, b) < edge * (1 + 1e-9)).map(([a, b]) => between(a, b, share));
}

/** A cube of half width 1 whose edges are cut back by `depth`, its corners with them. */
export function bevelledCube(depth: number): Vec3[] {
  return cyclic([1, 1 - depth, 1 - depth]).flatMap(signed);
}

/** A regular polygon of circumradius 1 at height y. */
function polygon(sides: number, y: number): Vec3[] {
  return Array.from({ length: sides }, (_, side) => {
    const turn = (2 * Math.PI * side) / sides;
    return [Math.cos(turn), y, Math.sin(turn)] as const;
  });
}

export const prism = (sides: number, height: number): Vec3[] => [
  ...polygon(sides, -height / 2),
  ...polygon(sides, height / 2),
];

/** The foot of circumradius 1 at y = 0. */
export const pyramid = (sides: number, height: number): Vec3[] => [...polygon(sides, 0), [0, height, 0]];

export const bipyramid = (sides: number, height: number): Vec3[] => [
  ...pyramid(sides, height / 2),
  [0, -height / 2, 0],
];
