import { joinPlaces } from '../mesh/weld.ts';
import { type Faces, none } from './parsed-file.ts';
import { newellVector, triangulate } from './polygon.ts';

/**
 * New values for the normals that a file stores.
 *
 * The rule. Around each place in space (welded position) the corners whose stored normals agree form a *fan*: a smooth
 * vertex is one fan, even where a texture seam has split it; a hard edge has one fan on each side. A stored normal
 * becomes the area-weighted mean of the new faces of the fans of all corners that use it. So what was smooth stays
 * smooth and what was hard stays hard. A normal that pointed into its faces does so again, a fan without area keeps its
 * normal, and so does one whose faces have not moved: the bytes of an untouched region do not change.
 *
 * A file that writes one normal for a whole flat side cannot tell its corners apart once the side is bent; they share
 * the mean.
 */

export interface StoredNormals {
  /** #N×3 as the file has them (any length). */
  readonly values: Float64Array;
  /** #C: which of them each corner uses, or {@link none}. */
  readonly ofCorner: Uint32Array;
}

/** Normals within 0.8° count as the same one: what rounding to bytes or four decimals leaves. */
const sameCosine = 0.9999;
/** At most this many fans around a place; more would be noise, and slow. */
const mostFans = 64;

/**
 * @param before #P×3 positions that the normals belong to
 * @param after #P×3 new positions
 * @returns #N×3 unit normals, NaN for those that stay as they are
 */
export function newNormals(
  faces: Faces,
  before: Float64Array,
  after: Float64Array,
  stored: StoredNormals,
): Float64Array {
  const sums = new FaceSums(faces, before, after);
  const units = unitVectors(stored.values);
  const { vertexOfPosition, positionOfVertex } = joinPlaces(before, triangulate(before, faces).triangles);
  const around = cornersByVertex(faces.corners, vertexOfPosition, positionOfVertex.length);
  const totals = new Totals(stored.values.length);
  const fans = new Fans(units, sums, totals);
  for (let v = 0; v + 1 < around.start.length; v++) {
    fans.begin();
    for (let k = around.start[v]; k < around.start[v + 1]; k++) {
      const normal = stored.ofCorner[around.corners[k]];
      if (normal !== none) fans.add(normal, around.corners[k]);
    }
    fans.end();
  }
  return totals.finish(units);
}

/** A unit normal for each face, in the new shape; NaN where the face has not moved or has no area. #F×3 */
export function newFaceNormals(
  faces: Faces,
  before: Float64Array,
  after: Float64Array,
  stored: Float64Array,
): Float64Array {
  const sums = new FaceSums(faces, before, after);
  const count = faces.start.length - 1;
  const totals = new Totals(3 * count);
  for (let f = 0; f < count; f++) {
    if (sums.moved[f] === 0) continue;
    totals.moved[f] = 1;
    for (let axis = 0; axis < 3; axis++) {
      totals.before[3 * f + axis] = sums.before[3 * f + axis];
      totals.after[3 * f + axis] = sums.after[3 * f + axis];
    }
  }
  return totals.finish(unitVectors(stored));
}

/** Area vectors of all faces before and after, and which faces have moved. */
class FaceSums {
  readonly before: Float64Array;
  readonly after: Float64Array;
  readonly moved: Uint8Array;
  readonly faceOfCorner: Uint32Array;

  constructor(faces: Faces, before: Float64Array, after: Float64Array) {
    const count = faces.start.length - 1;
    this.before = new Float64Array(3 * count);
    this.after = new Float64Array(3 * count);
    this.moved = new Uint8Array(count);
    this.faceOfCorner = new Uint32Array(faces.corners.length);
    for (let f = 0; f < count; f++) {
      const begin = faces.start[f];
      const end = faces.start[f + 1];
      newellVector(before, faces.corners, begin, end, this.before.subarray(3 * f, 3 * f + 3));
      newellVector(after, faces.corners, begin, end, this.after.subarray(3 * f, 3 * f + 3));
      for (let c = begin; c < end; c++) {
        this.faceOfCorner[c] = f;
        const p = 3 * faces.corners[c];
        for (let i = p; i < p + 3; i++) if (before[i] !== after[i]) this.moved[f] = 1;
      }
    }
  }
}

/** Sums for each stored normal. */
class Totals {
  readonly before: Float64Array;
  readonly after: Float64Array;
  readonly moved: Uint8Array;

  constructor(length: number) {
    this.before = new Float64Array(length);
    this.after = new Float64Array(length);
    this.moved = new Uint8Array(length / 3);
  }

  finish(stored: Float64Array): Float64Array {
    const { before, after } = this;
    const result = new Float64Array(after.length).fill(Number.NaN);
    for (let n = 0; n < this.moved.length; n++) {
      if (this.moved[n] === 0) continue;
      const i = 3 * n;
      const length = Math.hypot(after[i], after[i + 1], after[i + 2]);
      if (!(length > 0) || length === Number.POSITIVE_INFINITY) continue;
      const side =
        stored[i] * before[i] + stored[i + 1] * before[i + 1] + stored[i + 2] * before[i + 2] < 0 ? -1 : 1;
      for (let axis = 0; axis < 3; axis++) result[i + axis] = (side * after[i + axis]) / length;
    }
    return result;
  }
}

/** The fans around one place. */
class Fans {
  readonly #units: Float64Array;
  readonly #sums: FaceSums;
  readonly #totals: Totals;
  /** The normal that stands for each fan, and the fan's sums: before (3), after (3). */
  readonly #leader = new Uint32Array(mostFans);
  readonly #fanSums = new Float64Array(6 * mostFans);
  readonly #fanMoved = new Uint8Array(mostFans);
  #count = 0;
  readonly #members: number[] = [];

  constructor(units: Float64Array, sums: FaceSums, totals: Totals) {
    this.#units = units;
    this.#sums = sums;
    this.#totals = totals;
  }

  begin(): void {
    this.#count = 0;
    this.#members.length = 0;
  }

  add(normal: number, corner: number): void {
    const fan = this.#fanOf(normal);
    const face = this.#sums.faceOfCorner[corner];
    for (let axis = 0; axis < 3; axis++) {
      this.#fanSums[6 * fan + axis] += this.#sums.before[3 * face + axis];
      this.#fanSums[6 * fan + 3 + axis] += this.#sums.after[3 * face + axis];
    }
    this.#fanMoved[fan] |= this.#sums.moved[face];
    this.#members.push(normal, fan);
  }

  end(): void {
    const { before, after, moved } = this.#totals;
    for (let m = 0; m < this.#members.length; m += 2) {
      const normal = this.#members[m];
      const fan = this.#members[m + 1];
      for (let axis = 0; axis < 3; axis++) {
        before[3 * normal + axis] += this.#fanSums[6 * fan + axis];
        after[3 * normal + axis] += this.#fanSums[6 * fan + 3 + axis];
      }
      moved[normal] |= this.#fanMoved[fan];
    }
  }

  #fanOf(normal: number): number {
    const u = this.#units;
    const i = 3 * normal;
    for (let fan = 0; fan < this.#count; fan++) {
      const j = 3 * this.#leader[fan];
      if (i === j || u[i] * u[j] + u[i + 1] * u[j + 1] + u[i + 2] * u[j + 2] > sameCosine) return fan;
    }
    const fan = Math.min(this.#count, mostFans - 1);
    if (fan === this.#count) {
      this.#leader[fan] = normal;
      this.#fanSums.fill(0, 6 * fan, 6 * fan + 6);
      this.#fanMoved[fan] = 0;
      this.#count++;
    }
    return fan;
  }
}

/** Corners sorted by the welded vertex at which they are. */
function cornersByVertex(corners: Uint32Array, vertexOfPosition: Uint32Array, vertices: number): Faces {
  const start = new Uint32Array(vertices + 1);
  for (const p of corners) start[vertexOfPosition[p] + 1]++;
  for (let v = 0; v < vertices; v++) start[v + 1] += start[v];
  const next = start.slice();
  const sorted = new Uint32Array(corners.length);
  for (let c = 0; c < corners.length; c++) sorted[next[vertexOfPosition[corners[c]]]++] = c;
  return { start, corners: sorted };
}

/** Vectors of length one; what has no direction becomes zero. */
function unitVectors(vectors: Float64Array): Float64Array {
  const units = new Float64Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3) {
    const length = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (!(length > 0 && length < Number.POSITIVE_INFINITY)) continue;
    for (let axis = 0; axis < 3; axis++) units[i + axis] = vectors[i + axis] / length;
  }
  return units;
}
