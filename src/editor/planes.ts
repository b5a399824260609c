import type { Mesh } from '../mesh/mesh.ts';
import { dot, length, type Vec3 } from '../mesh/vectors.ts';
import { weldOf } from '../mesh/weld.ts';
import type { Plane, Planes } from '../methods/values/planes.ts';

/** Changes of the planes that vertices are held on, each a new list. */

/**
 * One more plane, last. Its vertices leave those that it is parallel to: nothing lies on two such. On others they stay, and are then
 * held on the line where the planes meet.
 */
export function withPlane(planes: Planes, mesh: Mesh, plane: Plane): Planes {
  if (plane.vertices.length === 0) return planes;
  const { vertexOfPosition } = weldOf(mesh);
  const taken = new Set(plane.vertices.map((position) => vertexOfPosition[position]!));
  const others = planes
    .map((other) =>
      areParallel(other.normal, plane.normal)
        ? {
            ...other,
            vertices: other.vertices.filter((position) => !taken.has(vertexOfPosition[position]!)),
          }
        : other,
    )
    .filter(({ vertices }) => vertices.length > 0);
  return [...others, plane];
}

export function withoutPlane(planes: Planes, index: number): Planes {
  return planes.filter((_, k) => k !== index);
}

/** A plane that lies elsewhere, or another way. */
export function placedPlane(
  planes: Planes,
  index: number,
  place: Partial<Pick<Plane, 'normal' | 'offset'>>,
): Planes {
  return planes.map((plane, k) => (k === index ? { ...plane, ...place } : plane));
}

function areParallel(a: Vec3, b: Vec3): boolean {
  return Math.abs(dot(a, b)) > (1 - 1e-9) * length(a) * length(b);
}
