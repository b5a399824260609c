import type { Mesh } from '../../mesh/mesh.ts';
import { between, row, type Vec3 } from '../../mesh/vectors.ts';
import { corners, meshOf, type Surface, type Triangle } from './surface.ts';

/**
 * Makes a surface of smaller triangles: every edge is halved until there are enough vertices. The shape and its normals
 * stay to rounding, but the flow to the sphere needs triangles to move: eight corners of a cube become no sphere.
 *
 * @param least vertices at least (default 2000, by which the flow keeps angles to a degree or two)
 * @returns a mesh with welded vertices; the surface itself, welded, if it has enough
 */
export function refined(surface: Surface, least = 2000): Mesh {
  const triangles = Array.from(
    { length: surface.triangles.length / 3 },
    (_, f): Triangle => [3 * f, 3 * f + 1, 3 * f + 2],
  );
  let mesh = meshOf(
    triangles.flatMap((_, face) => corners(surface, face)),
    triangles,
  );
  while (mesh.positions.length / 3 < least && mesh.triangles.length > 0) mesh = halved(mesh);
  return mesh;
}

/** Every triangle becomes four. */
function halved(mesh: Mesh): Mesh {
  const points: Vec3[] = Array.from({ length: mesh.positions.length / 3 }, (_, v) => row(mesh.positions, v));
  const middles = new Map<string, number>();
  const middle = (a: number, b: number): number => {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    const known = middles.get(key) ?? points.push(between(points[a]!, points[b]!, 0.5)) - 1;
    middles.set(key, known);
    return known;
  };
  const triangles: Triangle[] = [];
  for (let corner = 0; corner < mesh.triangles.length; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => mesh.triangles[corner + k]!) as [number, number, number];
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    triangles.push([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]);
  }
  return meshOf(points, triangles);
}
