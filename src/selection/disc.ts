import { row, type Vec3 } from '../mesh/vectors.ts';
import type { SelectableMesh } from './selectable.ts';
import { otherEnd } from './topology.ts';

/** A place on a surface. */
export interface SurfacePoint {
  readonly face: number;
  /** Shares of the corners; they add up to 1. */
  readonly weights: readonly [number, number, number];
}

/** Where a place is, in file units. */
export function placeOf({ topology, places }: SelectableMesh, { face, weights }: SurfacePoint): Vec3 {
  const place: [number, number, number] = [0, 0, 0];
  for (let corner = 0; corner < 3; corner++) {
    const at = row(places, topology.triangles[3 * face + corner]!);
    for (let axis = 0; axis < 3; axis++) place[axis]! += weights[corner]! * at[axis]!;
  }
  return place;
}

/**
 * The vertices within a distance of a place that can be reached from it without leaving the ball: a brush on one leg leaves the
 * other leg alone. The nearest corner of the face always counts.
 *
 * @param radius in file units
 */
export function discAround(surface: SelectableMesh, point: SurfacePoint, radius: number): Uint32Array {
  const { topology, places, visits } = surface;
  const [x, y, z] = placeOf(surface, point);
  const heaviest = point.weights.indexOf(Math.max(...point.weights));
  const found = [topology.triangles[3 * point.face + heaviest]!];
  visits.begin();
  visits.vertex(found[0]!);
  const within = (v: number) =>
    (places[3 * v]! - x) ** 2 + (places[3 * v + 1]! - y) ** 2 + (places[3 * v + 2]! - z) ** 2 <=
    radius * radius;
  for (let corner = 3 * point.face; corner < 3 * point.face + 3; corner++) {
    const v = topology.triangles[corner]!;
    if (visits.vertex(v) && within(v)) found.push(v);
  }
  for (let at = 0; at < found.length; at++) {
    const v = found[at]!;
    for (let i = topology.aroundStart[v]!; i < topology.aroundStart[v + 1]!; i++) {
      const w = otherEnd(topology, topology.edgesAround[i]!, v);
      if (visits.vertex(w) && within(w)) found.push(w);
    }
  }
  return Uint32Array.from(found);
}
