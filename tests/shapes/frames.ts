import { cross, dot, row, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Shape } from './shape.ts';

export type Triangles = Pick<Shape, 'positions' | 'triangles'>;
export type Frame = readonly [Vec3, Vec3, Vec3];

/** Two sides of a face and its normal. */
export function frameOf({ positions, triangles }: Triangles, face: number, normal: Vec3): Frame {
  const [a, b, c] = [0, 1, 2].map((k) => row(positions, triangles[3 * face + k]!)) as [Vec3, Vec3, Vec3];
  return [subtract(b, a), subtract(c, a), normal];
}

/** What a vector is in a frame. */
export function coordinates([u, v, w]: Frame, vector: Vec3): Vec3 {
  const size = dot(u, cross(v, w));
  return [dot(vector, cross(v, w)) / size, dot(vector, cross(w, u)) / size, dot(vector, cross(u, v)) / size];
}
