import type { Mesh } from '../../mesh/mesh.ts';
import type { Vec3 } from '../../mesh/vectors.ts';
import { meshOf, type Triangle } from './surface.ts';

/**
 * A cube of half width 1 whose top is turned against its foot.
 *
 * @param resolution squares along an edge; 6 n² + 2 vertices
 * @param twist angle between top and foot, in radians
 */
export function twistedCube(resolution: number, twist: number): Mesh {
  const points: Vec3[] = [];
  const triangles: Triangle[] = [];
  const place = (at: number): number => (2 * at) / resolution - 1;
  const vertex = (axis: number, height: number, u: number, w: number): number => {
    const p: [number, number, number] = [0, 0, 0];
    p[axis] = height;
    p[(axis + 1) % 3] = place(u);
    p[(axis + 2) % 3] = place(w);
    return points.push(turned(p, (twist / 2) * p[1])) - 1;
  };
  for (const axis of [0, 1, 2])
    for (const height of [1, -1])
      for (let u = 0; u < resolution; u++)
        for (let w = 0; w < resolution; w++) {
          const [a, b, c, d] = [
            vertex(axis, height, u, w),
            vertex(axis, height, u + 1, w),
            vertex(axis, height, u + 1, w + 1),
            vertex(axis, height, u, w + 1),
          ];
          if (height > 0) triangles.push([a, b, c], [a, c, d]);
          else triangles.push([a, c, b], [a, d, c]);
        }
  return meshOf(points, triangles);
}

/** Turned around the y axis. */
function turned([x, y, z]: Vec3, angle: number): Vec3 {
  return [x * Math.cos(angle) + z * Math.sin(angle), y, z * Math.cos(angle) - x * Math.sin(angle)];
}
