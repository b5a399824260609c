import { add, dot, row, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import { coordinates, frameOf, type Triangles } from './frames.ts';
import type { SurfaceFacts } from './surface-facts.ts';

/** A face, and where the ray from its middle through the body comes out. */
export interface Wall {
  readonly face: number;
  readonly behind: number;
  readonly weights: Vec3;
  readonly thickness: number;
}

/** Where a body is thinner than a seventh of the diagonal and has parallel sides; some hundred places. */
export function wallsOf({ mesh, normals, diagonal, sound }: SurfaceFacts): Wall[] {
  const stride = Math.max(1, Math.floor(normals.length / 300));
  return normals.flatMap((normal, face) => {
    if (face % stride !== 0 || !sound[face]) return [];
    const from = middleOf(mesh, face);
    const hits = normals.flatMap((other, behind): Wall[] => {
      if (dot(normal, other) > -0.98) return [];
      const a = row(mesh.positions, mesh.triangles[3 * behind]!);
      const thickness = dot(subtract(from, a), other) / dot(normal, other);
      if (thickness < 1e-6 * diagonal || thickness > diagonal / 7) return [];
      const at = subtract(subtract(from, scale(normal, thickness)), a);
      const [u, v] = coordinates(frameOf(mesh, behind, other), at);
      return u < 0 || v < 0 || u + v > 1 ? [] : [{ face, behind, weights: [1 - u - v, u, v], thickness }];
    });
    return hits.toSorted((x, y) => x.thickness - y.thickness).slice(0, 1);
  });
}

function thickening(
  { face, behind, weights, thickness }: Wall,
  after: Triangles,
  now: readonly Vec3[],
): number {
  const through = subtract(middleOf(after, face), middleOf(after, behind, weights));
  return Math.abs(dot(through, now[behind]!) / -thickness - 1);
}

function middleOf(
  { positions, triangles }: Triangles,
  face: number,
  weights: Vec3 = [1 / 3, 1 / 3, 1 / 3],
): Vec3 {
  return weights.reduce((sum, w, k) => add(sum, scale(row(positions, triangles[3 * face + k]!), w)), [
    0, 0, 0,
  ] as Vec3);
}

/** The largest change of thickness, but for 5 % of the places, as a share of it. @param now normals of all faces after */
export function changeOfThickness(walls: readonly Wall[], after: Triangles, now: readonly Vec3[]): number {
  return quantile(
    walls.map((wall) => thickening(wall, after, now)),
    0.95,
  );
}

/** The value that a share of the values stays below; 0 where there are none. */
export function quantile(values: readonly number[], share: number): number {
  return values.toSorted((a, b) => a - b)[Math.floor(share * Math.max(0, values.length - 1))] ?? 0;
}
