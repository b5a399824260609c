import { distinctFaces } from './distinct-faces.ts';
import { areSound } from './half-edges.ts';
import type { SolvedFaces } from './mesh.ts';
import { orient } from './orient.ts';

/**
 * Counts each face once and turns faces so that neighbours across an edge of two look the same way, see `orient.ts`. Of faces
 * that repeat each other, whichever way they look, the first stays.
 *
 * @param positions #V×3
 * @param triangles #F×3 welded vertices; faces that use one twice or one that does not exist stay as they are
 * @returns undefined where the faces are good as they are
 */
export function solvedFacesOf(
  positions: Float64Array,
  triangles: Uint32Array<ArrayBuffer>,
): SolvedFaces | undefined {
  if (areSound(triangles, positions.length / 3)) return undefined;
  const { faceOf, solvedOf } = distinctFaces(triangles);
  const kept = cornersOfSolved(triangles, { faceOf, isTurned: new Uint8Array(faceOf.length) });
  const { isTurned, oneSidedEdges } = orient(positions, kept);
  const turned = isTurned.reduce((sum, is) => sum + is, 0);
  const repeated = triangles.length / 3 - faceOf.length;
  if (repeated === 0 && turned === 0 && oneSidedEdges === 0) return undefined;
  const faces = { faceOf, solvedOf, isTurned, repeated, turned, oneSidedEdges };
  return { ...faces, triangles: cornersOfSolved(triangles, faces) };
}

/**
 * What belongs to the corners of a file's faces, for the corners of those that are solved.
 *
 * @param ofCorners 3·#F×`size`
 * @returns 3·#S×`size`
 */
export function cornersOfSolved<T extends Uint32Array | Float32Array>(
  ofCorners: T,
  { faceOf, isTurned }: Pick<SolvedFaces, 'faceOf' | 'isTurned'>,
  size = 1,
): T {
  const result = ofCorners.slice(0, 3 * size * faceOf.length) as T;
  for (let face = 0; face < faceOf.length; face++) {
    for (let k = 0; k < 3; k++) {
      const from = size * (3 * faceOf[face]! + (isTurned[face] === 1 ? (3 - k) % 3 : k));
      const to = size * (3 * face + k);
      for (let i = 0; i < size; i++) result[to + i] = ofCorners[from + i]!;
    }
  }
  return result;
}
