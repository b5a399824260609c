import { cross, dot, row, scale, subtract, unit, type Vec3 } from '../../../src/mesh/vectors.ts';
import { fittedRound, principalAxes } from '../fits.ts';
import type { Kept } from '../measures.ts';
import type { Round, Shape } from '../shape.ts';

/** What becomes of the size of a cylinder that may lean otherwise afterwards: seen along its own axis then. */
export function keptRound(shape: Shape, round: Round, positions: Float64Array): Kept {
  const { name, vertices, axis } = round;
  const before = fittedRound(shape.positions, vertices, axis);
  const after = fittedRound(positions, vertices, axis && axisOf(shape, vertices, axis, positions));
  return { name, ratio: after.radius / before.radius, roundness: after.roundness };
}

/** The direction to which the faces of a cylinder are most at right angles. */
function axisOf(
  { positions: rest, triangles }: Shape,
  vertices: readonly number[],
  axis: Vec3,
  positions: Float64Array,
): Vec3 {
  const on = new Set(vertices);
  const normals: number[] = [];
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const face = [...triangles.subarray(corner, corner + 3)];
    if (!face.every((v) => on.has(v)) || Math.abs(dot(unit(normalOf(rest, face)), unit(axis))) > 0.1)
      continue;
    // Both ways, so that their middle is the origin; long faces count more.
    const normal = normalOf(positions, face);
    normals.push(...normal, ...scale(normal, -1));
  }
  return principalAxes(
    Float64Array.from(normals),
    Array.from({ length: normals.length / 3 }, (_, k) => k),
  ).axes[0];
}

function normalOf(positions: Float64Array, face: readonly number[]): Vec3 {
  const [a, b, c] = face.map((v) => row(positions, v)) as [Vec3, Vec3, Vec3];
  return cross(subtract(b, a), subtract(c, a));
}
