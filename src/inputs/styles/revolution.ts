import type { Mesh } from '../../mesh/mesh.ts';
import type { Vec3 } from '../../mesh/vectors.ts';
import { lengthOf, RowMesh, resampled } from './rows.ts';

/** A point of a profile: distance from the axis and height. */
export type ProfilePoint = readonly [radius: number, y: number];

/**
 * A surface of revolution around the y axis, with triangles of about one size.
 *
 * @param pieces the profile from the lower end of the axis to the upper one; where one piece ends and the next begins,
 *   an edge stays sharp
 * @param edge length of the triangles' edges
 */
export function revolved(pieces: readonly (readonly ProfilePoint[])[], edge: number): Mesh {
  const mesh = new RowMesh();
  let below: readonly number[] | undefined;
  for (const [radius, y] of sampledProfile(pieces, edge)) {
    const row = mesh.add(circle(radius, y, edge));
    if (below) mesh.stitch(below, row);
    below = row;
  }
  return mesh.mesh();
}

function sampledProfile(pieces: readonly (readonly ProfilePoint[])[], edge: number): ProfilePoint[] {
  // Rows of equilateral triangles are closer to each other than their points.
  const spacing = (edge * Math.sqrt(3)) / 2;
  const all = pieces.flatMap((piece, index) => {
    const line = piece.map(([radius, y]): Vec3 => [radius, y, 0]);
    const points = resampled(line, Math.max(1, Math.round(lengthOf(line) / spacing)));
    return index === 0 ? points : points.slice(1);
  });
  return all.map(([radius, y]) => [radius, y]);
}

/** Counter-clockwise seen from the foot, so that the surface shows its outside; one point on the axis. */
function circle(radius: number, y: number, edge: number): Vec3[] {
  if (radius === 0) return [[0, y, 0]];
  const count = Math.max(5, Math.round((2 * Math.PI * radius) / edge));
  const points = Array.from({ length: count }, (_, k): Vec3 => {
    const turn = (-2 * Math.PI * k) / count;
    return [radius * Math.cos(turn), y, radius * Math.sin(turn)];
  });
  return [...points, points[0]!];
}
