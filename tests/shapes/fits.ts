import { add, dot, row, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';

/** Middle of some points and their principal axes, along which they reach least first. */
export interface Axes {
  readonly middle: Vec3;
  readonly axes: readonly [Vec3, Vec3, Vec3];
}

/** @param positions #V×3   @param which of them */
export function principalAxes(positions: Float64Array, which: readonly number[]): Axes {
  const points = which.map((v) => row(positions, v));
  const middle = scale(points.reduce(add, [0, 0, 0]), 1 / points.length);
  const spread = [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => points.reduce((sum, p) => sum + (p[i]! - middle[i]!) * (p[j]! - middle[j]!), 0)),
  );
  return { middle, axes: eigenvectors(spread) };
}

/** How far the points reach along a direction. */
export function extent(positions: Float64Array, which: readonly number[], along: Vec3): number {
  const values = which.map((v) => dot(row(positions, v), along));
  return Math.max(...values) - Math.min(...values);
}

/** Of a symmetric matrix, by growing eigenvalue, with Jacobi's rotations. */
function eigenvectors(matrix: readonly (readonly number[])[]): [Vec3, Vec3, Vec3] {
  const a = matrix.map((line) => [...line]);
  const v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; // biome-ignore format: a matrix
  for (let sweep = 0; sweep < 20; sweep++)
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      // biome-ignore format: pairs
      if (a[p]![q] === 0) continue;
      const theta = (a[q]![q]! - a[p]![p]!) / (2 * a[p]![q]!);
      const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.hypot(theta, 1));
      const c = 1 / Math.hypot(t, 1);
      const turn = (m: number[][], k: number, byRow: boolean) => {
        const [x, y] = byRow ? [m[p]![k]!, m[q]![k]!] : [m[k]![p]!, m[k]![q]!];
        const [u, w] = [c * (x - t * y), c * (t * x + y)];
        if (byRow) [m[p]![k], m[q]![k]] = [u, w];
        else [m[k]![p], m[k]![q]] = [u, w];
      };
      for (const k of [0, 1, 2]) turn(a, k, true);
      for (const k of [0, 1, 2]) turn(a, k, false);
      for (const k of [0, 1, 2]) turn(v, k, false);
    }
  const order = [0, 1, 2].sort((i, j) => a[i]![i]! - a[j]![j]!);
  return order.map((k): Vec3 => [v[0]![k]!, v[1]![k]!, v[2]![k]!]) as [Vec3, Vec3, Vec3];
}

export interface FittedRound {
  readonly radius: number;
  /** Root mean square of the distances from it, as a share of the radius. */
  readonly roundness: number;
}

/** The ball, or with an axis the cylinder about it, that points lie nearest to (algebraic least squares, Kåsa 1976). */
export function fittedRound(positions: Float64Array, which: readonly number[], axis?: Vec3): FittedRound {
  const all = which.map((v) => row(positions, v));
  const origin = scale(all.reduce(add, [0, 0, 0]), 1 / all.length);
  const flat = (p: Vec3): Vec3 => (axis ? subtract(p, scale(unit(axis), dot(p, unit(axis)))) : p);
  const points = all.map((p) => flat(subtract(p, origin)));
  // |p|² = 2 p·c + k for the middle c; along an axis nothing is known of it, which a weight settles.
  const rows = points.map((p) => ({ of: [2 * p[0], 2 * p[1], 2 * p[2], 1], is: dot(p, p) }));
  if (axis) rows.push({ of: [...unit(axis), 0], is: 0 });
  const system = [0, 1, 2, 3].map((i) => [
    ...[0, 1, 2, 3].map((j) => rows.reduce((sum, { of }) => sum + of[i]! * of[j]!, 0)),
    rows.reduce((sum, { of, is }) => sum + of[i]! * is, 0),
  ]);
  const [x, y, z, k] = solved(system) as [number, number, number, number];
  const radius = Math.sqrt(k + x * x + y * y + z * z);
  const squares = points.map((p) => (Math.hypot(p[0] - x, p[1] - y, p[2] - z) - radius) ** 2);
  return { radius, roundness: Math.sqrt(squares.reduce((a, b) => a + b, 0) / squares.length) / radius };
}

/** Gauss’ elimination of rows that end with their right-hand side. */
function solved(rows: number[][]): number[] {
  const n = rows.length;
  for (let k = 0; k < n; k++) {
    const pivot = rows
      .slice(k)
      .reduce((best, candidate) => (Math.abs(candidate[k]!) > Math.abs(best[k]!) ? candidate : best));
    rows.splice(rows.indexOf(pivot), 1);
    rows.splice(k, 0, pivot);
    for (const [i, other] of rows.entries()) {
      if (i === k) continue;
      const factor = other[k]! / pivot[k]!;
      for (let j = k; j <= n; j++) other[j]! -= factor * pivot[j]!;
    }
  }
  return rows.map((line, k) => line[n]! / line[k]!);
}
