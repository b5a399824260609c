// The twin in the core is wasm/core/mesh/extent.cpp, which the unit frame goes by; both share their constants.
import { type FaceShape, measureFace } from './areas.ts';
import type { Mesh } from './mesh.ts';

/** A box of positions and the length of its diagonal; of nothing, a diagonal of 0. */
export interface Extent {
  readonly min: readonly [x: number, y: number, z: number];
  readonly max: readonly [x: number, y: number, z: number];
  readonly diagonal: number;
}

/** An empty gap is far if it is so many times as long as all that faces cover on the axis on which they cover most. */
const farGap = 100;
const bins = 2 ** 16;

/**
 * The box of what matters in a mesh: of the faces without far strays, which would make all the rest a dot in the box. Of the
 * pieces that far gaps cut the mesh into, along one axis after the other, the one with the largest surface matters.
 *
 * @param positions #P×3; what no face uses does not count, whatever it holds
 * @param triangles #F×3; faces with corners that do not exist or are not finite do not count
 */
export function extentOf(positions: Float64Array, triangles: Uint32Array): Extent {
  let faces: Faces = { positions, triangles, list: usableFaces(positions, triangles) };
  for (;;) {
    const extent = boxOf(faces);
    const near = withoutStrays(faces, extent);
    if (near === faces) return extent;
    faces = near;
  }
}

const diagonals = new WeakMap<Float64Array, number>();

/** The diagonal of a mesh's {@link extentOf}, measured once a mesh: brushes ask for it all the time. */
export function diagonalOf({ positions, triangles }: Pick<Mesh, 'positions' | 'triangles'>): number {
  const known = diagonals.get(positions) ?? extentOf(positions, triangles).diagonal;
  diagonals.set(positions, known);
  return known;
}

interface Faces {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  readonly list: Uint32Array;
}

function usableFaces(positions: Float64Array, triangles: Uint32Array): Uint32Array {
  const list = new Uint32Array(triangles.length / 3);
  let count = 0;
  for (let face = 0; face < list.length; face++) {
    let sum = 0;
    for (let c = 3 * face; c < 3 * face + 3; c++) {
      const p = 3 * triangles[c]!;
      // Beyond the end of the array lies undefined, which makes NaN.
      sum += positions[p]! + positions[p + 1]! + positions[p + 2]!;
    }
    if (Number.isFinite(sum)) list[count++] = face;
  }
  return list.subarray(0, count);
}

function boxOf({ positions, triangles, list }: Faces): Extent {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const face of list) {
    for (let c = 3 * face; c < 3 * face + 3; c++) {
      const p = 3 * triangles[c]!;
      for (let axis = 0; axis < 3; axis++) {
        const x = positions[p + axis]!;
        if (x < min[axis]!) min[axis] = x;
        if (x > max[axis]!) max[axis] = x;
      }
    }
  }
  if (list.length === 0) return { min: [0, 0, 0], max: [0, 0, 0], diagonal: 0 };
  return { min, max, diagonal: Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]) };
}

/** The faces of the largest piece along the first axis that has a far gap; the very same where none has. */
function withoutStrays(faces: Faces, { min, max }: Extent): Faces {
  const sizes = [0, 1, 2].map((axis) => (max[axis]! - min[axis]!) / bins);
  const longest = sizes.indexOf(Math.max(...sizes));
  if (isWellCovered(faces, longest, min[longest]!, sizes[longest]!)) return faces;
  const covers = sizes.map((size, axis) => (size > 0 ? coverOf(faces, axis, min[axis]!, size) : undefined));
  const covered = covers.map((cover, axis) => (cover ? sizes[axis]! * coveredBins(cover) : 0));
  const far = farGap * Math.max(...covered);
  for (let axis = 0; axis < 3; axis++) {
    const cover = covers[axis];
    const piece = cover && pieceOfBin(cover, far / sizes[axis]!);
    if (piece && piece[bins - 1]! > 0) return largestPiece(faces, axis, min[axis]!, sizes[axis]!, piece);
  }
  return faces;
}

/** Whether one of a few thousand faces, or all of these, cover so much of the longest axis that no gap can be far. */
function isWellCovered(
  { positions, triangles, list }: Faces,
  axis: number,
  low: number,
  size: number,
): boolean {
  if (!(size > 0)) return true;
  const isCovered = new Uint8Array(bins);
  let count = 0;
  const stride = Math.ceil(list.length / 8192);
  for (let i = 0; i < list.length; i += stride) {
    const [a, b] = [0, 1].map((k) => positions[3 * triangles[3 * list[i]! + k]! + axis]!) as [number, number];
    if (farGap * Math.abs(b - a) > size * bins) return true;
    const bin = binOf(a, low, size);
    if (isCovered[bin] === 1) continue;
    isCovered[bin] = 1;
    if (farGap * ++count > bins) return true;
  }
  return false;
}

const binOf = (x: number, low: number, size: number): number =>
  Math.min(bins - 1, Math.floor((x - low) / size));

/** How many faces lie over each bin of an axis. */
function coverOf({ positions, triangles, list }: Faces, axis: number, low: number, size: number): Int32Array {
  const cover = new Int32Array(bins + 1);
  for (const face of list) {
    const a = positions[3 * triangles[3 * face]! + axis]!;
    const b = positions[3 * triangles[3 * face + 1]! + axis]!;
    const c = positions[3 * triangles[3 * face + 2]! + axis]!;
    cover[binOf(Math.min(a, b, c), low, size)]! += 1;
    cover[binOf(Math.max(a, b, c), low, size) + 1]! -= 1;
  }
  for (let bin = 1; bin < bins; bin++) cover[bin]! += cover[bin - 1]!;
  return cover;
}

function coveredBins(cover: Int32Array): number {
  let count = 0;
  for (let bin = 0; bin < bins; bin++) if (cover[bin]! > 0) count++;
  return count;
}

/** The piece in which each bin lies, from 0 on, cut where more than `far` bins are empty. */
function pieceOfBin(cover: Int32Array, far: number): Int32Array {
  const piece = new Int32Array(bins);
  let empty = 0;
  let count = 0;
  for (let bin = 0; bin < bins; bin++) {
    if (cover[bin]! > 0) {
      if (empty > far) count++;
      empty = 0;
    } else empty++;
    piece[bin] = count;
  }
  return piece;
}

function largestPiece(faces: Faces, axis: number, low: number, size: number, pieceOf: Int32Array): Faces {
  const { positions, triangles, list } = faces;
  const pieceOfFace = (face: number): number =>
    pieceOf[binOf(positions[3 * triangles[3 * face]! + axis]!, low, size)]!;
  const areas = new Float64Array(pieceOf[bins - 1]! + 1);
  const shape: FaceShape = [0, 0, 0, 0];
  for (const face of list) {
    measureFace(positions, triangles, face, shape);
    areas[pieceOfFace(face)]! += shape[3];
  }
  const largest = areas.indexOf(Math.max(...areas));
  return { positions, triangles, list: list.filter((face) => pieceOfFace(face) === largest) };
}
