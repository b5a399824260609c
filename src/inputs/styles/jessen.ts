import type { Mesh } from '../../mesh/mesh.ts';
import { add, dot, doubledAreaVector, scale, type Vec3 } from '../../mesh/vectors.ts';
import { meshOf, type Triangle } from './surface.ts';

/**
 * Jessen's icosahedron: corners (±2, ±1, 0) and their turns, six grooves, all its faces at right angles.
 *
 * @param resolution parts of every edge; 10 n² + 2 vertices
 */
export function jessen(resolution: number): Mesh {
  const triangles = faces().flatMap((face) => subdivided(face, resolution));
  const points = triangles.flat().map(rounded);
  return meshOf(
    points,
    triangles.map((_, t): Triangle => [3 * t, 3 * t + 1, 3 * t + 2]),
  );
}

type Face = readonly [Vec3, Vec3, Vec3];

function faces(): Face[] {
  const signs = [1, -1];
  const turned = (turn: number, [x, y, z]: Vec3): Vec3 =>
    turn === 0 ? [x, y, z] : turn === 1 ? [z, x, y] : [y, z, x];
  const found: Face[] = [];
  for (const a of signs)
    for (const b of signs) {
      // One equilateral triangle in every octant, …
      for (const c of signs)
        found.push(
          [
            [2 * a, b, 0],
            [0, 2 * b, c],
            [a, 0, 2 * c],
          ].map(vec) as unknown as Face,
        );
      // … and from the bottom of every groove one to each side.
      for (const turn of [0, 1, 2])
        found.push(
          [
            [2, a, 0],
            [-2, a, 0],
            [0, 2 * a, b],
          ].map((p) => turned(turn, vec(p))) as unknown as Face,
        );
    }
  return found.map(outward);
}

const vec = (p: readonly number[]): Vec3 => [p[0]!, p[1]!, p[2]!];

/** Seen from the centre the surface hides nothing, so outward is away from it. */
function outward([a, b, c]: Face): Face {
  return dot(doubledAreaVector(a, b, c), add(add(a, b), c)) > 0 ? [a, b, c] : [a, c, b];
}

/** A triangle cut into n² like it. */
function subdivided([a, b, c]: Face, n: number): Face[] {
  const at = (i: number, j: number): Vec3 =>
    scale(add(add(scale(a, n - i - j), scale(b, i)), scale(c, j)), 1 / n);
  const parts: Face[] = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; i + j < n; j++) {
      parts.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
      if (i + j + 1 < n) parts.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return parts;
}

/** Faces that share an edge must agree about its points to the bit. */
const rounded = (p: Vec3): Vec3 => vec(p.map((x) => Math.round(x * 1e9) / 1e9));
