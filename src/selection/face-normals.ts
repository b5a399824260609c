import { faceCount, faceOfSide, none, sideAcross, type Topology } from './topology.ts';
import { pieceLength, type Work } from './work.ts';

/** A face counts as a sliver if its height over its longest side is less than this share of that side. */
const sliver = 1e-6;

/**
 * Unit normals of faces, #S×3, of positions #V×3. A sliver, which looks nowhere, has the normal of the face across its longest
 * side: it lies in that face, but for rounding.
 */
export function* faceNormals(topology: Topology, positions: Float64Array): Work<Float32Array> {
  const { triangles } = topology;
  const faces = faceCount(topology);
  const normals = new Float32Array(3 * faces);
  const slivers: number[] = [];
  for (let face = 0; face < faces; face++) {
    if (face % pieceLength === 0) yield;
    const a = 3 * triangles[3 * face]!;
    const b = 3 * triangles[3 * face + 1]!;
    const c = 3 * triangles[3 * face + 2]!;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const size = Math.sqrt(x * x + y * y + z * z);
    const longest = Math.max(
      ux * ux + uy * uy + uz * uz,
      vx * vx + vy * vy + vz * vz,
      (vx - ux) ** 2 + (vy - uy) ** 2 + (vz - uz) ** 2,
    );
    if (size > sliver * longest) {
      normals[3 * face] = x / size;
      normals[3 * face + 1] = y / size;
      normals[3 * face + 2] = z / size;
    } else slivers.push(face);
  }
  for (const face of slivers) borrow(topology, positions, normals, face);
  return normals;
}

/** Slivers lie in chains; whoever finds no normal within some steps keeps none, and all its sides are features. */
const mostSteps = 16;

function borrow(topology: Topology, positions: Float64Array, normals: Float32Array, face: number): void {
  let at = face;
  for (let step = 0; step < mostSteps; step++) {
    const across = sideAcross(topology, longestSide(topology, positions, at));
    if (across === none) return;
    at = faceOfSide(across);
    const n = 3 * at;
    if (normals[n] === 0 && normals[n + 1] === 0 && normals[n + 2] === 0) continue;
    normals.copyWithin(3 * face, n, n + 3);
    return;
  }
}

function longestSide({ triangles }: Topology, positions: Float64Array, face: number): number {
  let longest = 3 * face;
  let most = -1;
  for (let side = 3 * face; side < 3 * face + 3; side++) {
    const v = 3 * triangles[side]!;
    const w = 3 * triangles[side === 3 * face + 2 ? 3 * face : side + 1]!;
    const square =
      (positions[v]! - positions[w]!) ** 2 +
      (positions[v + 1]! - positions[w + 1]!) ** 2 +
      (positions[v + 2]! - positions[w + 2]!) ** 2;
    if (square > most) [longest, most] = [side, square];
  }
  return longest;
}
