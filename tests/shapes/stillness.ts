import { dot, row, subtract } from '../../src/mesh/vectors.ts';
import { farthest } from '../benchmarks/numbers.ts';
import type { TestMesh } from '../fixtures/subdivision.ts';
import { diagonalOf, normalsOf } from './surface-facts.ts';

/** The farthest that vertices went, as shares of the diagonal of the box around the shape before. */
export interface Moves {
  readonly anyway: number;
  /** Along the normals of faces: what slides within a flat side is not seen. */
  readonly outOfFaces: number;
}

/** What the last fifth of the iterations moved. @param ways the positions after each iteration */
export function lateMoves(shape: TestMesh, ways: readonly Float64Array[]): Moves {
  const [from, to] = [ways[Math.ceil(0.8 * ways.length) - 1]!, ways.at(-1)!];
  const normals = normalsOf(shape);
  const diagonal = diagonalOf(shape.positions);
  let out = 0;
  for (const [corner, v] of shape.triangles.entries()) {
    const moved = subtract(row(to, v), row(from, v));
    out = Math.max(out, Math.abs(dot(moved, normals[Math.floor(corner / 3)]!)));
  }
  return { anyway: farthest(from, to) / diagonal, outOfFaces: out / diagonal };
}
