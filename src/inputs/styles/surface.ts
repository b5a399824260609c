import type { Mesh } from '../../mesh/mesh.ts';
import { cross, dot, doubledAreaVector, row, type Vec3 } from '../../mesh/vectors.ts';
import { gather, joinPlaces } from '../../mesh/weld.ts';

/** What the shapes here are made of: a {@link Mesh} is one, a solver's result another. */
export type Surface = Pick<Mesh, 'positions' | 'triangles'>;

/** Three indices of points. */
export type Triangle = readonly [number, number, number];

/** A mesh of points and triangles; equal points become one vertex. */
export function meshOf(points: readonly Vec3[], triangles: readonly Triangle[]): Mesh {
  const positions = Float64Array.from(points.flat());
  const joined = joinPlaces(positions, Uint32Array.from(triangles.flat()));
  return { positions: gather(positions, joined), triangles: joined.triangles };
}

/** The corners of a face. */
export function corners({ positions, triangles }: Surface, face: number): [Vec3, Vec3, Vec3] {
  const corner = (k: number): Vec3 => row(positions, triangles[3 * face + k]!);
  return [corner(0), corner(1), corner(2)];
}

/** Doubled area times unit normal of every face, #F×3. */
export function areaVectors(surface: Surface): Float64Array<ArrayBuffer> {
  const vectors = new Float64Array(surface.triangles.length);
  for (let face = 0; 3 * face < vectors.length; face++)
    vectors.set(doubledAreaVector(...corners(surface, face)), 3 * face);
  return vectors;
}

/** Volume inside a closed surface; negative if it is inside out. */
export function volume(surface: Surface): number {
  let sixfold = 0;
  for (let face = 0; 3 * face < surface.triangles.length; face++) {
    const [a, b, c] = corners(surface, face);
    sixfold += dot(a, cross(b, c));
  }
  return sixfold / 6;
}
