import { distance } from '../../src/mesh/vectors.ts';
import { pieces, type Stretch } from './outline.ts';
import type { Solid } from './solid.ts';

/** Vertices around the axis, counter-clockwise from above; one at the axis. */
type Ring = readonly number[];

export interface Revolved {
  /**
   * Stretches in (distance from the axis, height), each beginning where the one before ends; upwards the outside is away from
   * the axis.
   */
  readonly profile: readonly Stretch[];
  /** Vertices of every ring; absent, as many as the fineness wants at its radius. */
  readonly columns?: number;
  /** Whether every other ring is turned by half a column; staggered triangles are even, others are ruled. */
  readonly staggered?: boolean;
}

/** A surface of revolution about the z axis. */
export function revolve(solid: Solid, { profile, columns, staggered = true }: Revolved): void {
  const rows = profile.flatMap((stretch, k) => {
    const count = pieces(stretch, solid.fineness);
    const inner = Array.from({ length: count }, (_, j) => stretch.at(j / count));
    return k + 1 === profile.length ? [...inner, stretch.at(1)] : inner;
  });
  const rings = rows.map(([radius, height], k): Ring => {
    if (radius < 1e-9) return [solid.vertex([0, 0, height])];
    const count = columns ?? solid.fineness.arc(radius, 2 * Math.PI);
    const phase = staggered ? (k % 2) / 2 : 0;
    return Array.from({ length: count }, (_, j) => {
      const angle = (2 * Math.PI * (j + phase)) / count;
      return solid.vertex([radius * Math.cos(angle), radius * Math.sin(angle), height]);
    });
  });
  for (let k = 1; k < rings.length; k++) stitch(solid, rings[k - 1]!, rings[k]!);
}

/** Triangles between two rings that go round the same way, by the shorter diagonal; a ring of one vertex is the tip of a fan. */
export function stitch(solid: Solid, low: Ring, high: Ring): void {
  const [m, n] = [low.length > 1 ? low.length : 0, high.length > 1 ? high.length : 0];
  const reach = (v: number, w: number) => distance(solid.at(v), solid.at(w));
  const nearest = Math.min(...high.map((w) => reach(low[0]!, w)));
  const shift = high.findIndex((w) => reach(low[0]!, w) < nearest + 1e-9);
  const below = (k: number) => low[k % low.length]!;
  const above = (k: number) => high[(k + shift) % high.length]!;
  for (let [i, j] = [0, 0]; i < m || j < n; ) {
    const isLowNext =
      j >= n || (i < m && reach(below(i + 1), above(j)) < reach(below(i), above(j + 1)) + 1e-9);
    if (isLowNext) solid.triangle(below(i), below(++i), above(j));
    else solid.triangle(below(i), above(++j), above(j - 1));
  }
}
