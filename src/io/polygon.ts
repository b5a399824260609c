import { clipEars } from './ear-clipping.ts';
import { IndexList } from './lists.ts';
import type { Faces } from './parsed-file.ts';

/** Point-in-triangle tests per file before the rest of its concave polygons is split as fans: about half a second. */
const testBudget = 3e7;

export interface Triangulation {
  /** #T×3 indices into the positions, faces in order, each with the winding of its polygon. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** #T×3: which corner of the polygons each of them is; absent if the faces were triangles already. */
  readonly corners?: Uint32Array<ArrayBuffer>;
  /** Concave polygons that were too large to be split without overlaps. */
  readonly roughFaces: number;
}

/**
 * Splits polygons into triangles: convex ones as a fan, concave ones by clipping ears in their Newell plane, flat or
 * tangled ones as well as it goes. An n-gon always gives n − 2 triangles.
 */
export function triangulate(positions: Float64Array, faces: Faces): Triangulation {
  const splitter = new PolygonSplitter(positions, faces.corners);
  const count = faces.start.length - 1;
  if (faces.corners.length === 3 * count) return { triangles: faces.corners.slice(), roughFaces: 0 };
  for (let f = 0; f < count; f++) splitter.split(faces.start[f], faces.start[f + 1]);
  const corners = splitter.triangles.take();
  return { triangles: corners.map((c) => faces.corners[c]), corners, roughFaces: splitter.roughFaces };
}

/**
 * Newell's normal of a polygon: twice its area, along its normal, right also if it is concave or not quite flat.
 * Written to `into` (x, y, z).
 */
export function newellVector(
  positions: Float64Array,
  corners: Uint32Array,
  begin: number,
  end: number,
  into: Float64Array,
): void {
  let nx = 0;
  let ny = 0;
  let nz = 0;
  // Relative to the first corner, or far-away meshes would lose their digits.
  const o = 3 * corners[begin];
  const ox = positions[o];
  const oy = positions[o + 1];
  const oz = positions[o + 2];
  let ax = 0;
  let ay = 0;
  let az = 0;
  for (let c = begin + 1; c < end; c++) {
    const p = 3 * corners[c];
    const bx = positions[p] - ox;
    const by = positions[p + 1] - oy;
    const bz = positions[p + 2] - oz;
    nx += ay * bz - az * by;
    ny += az * bx - ax * bz;
    nz += ax * by - ay * bx;
    ax = bx;
    ay = by;
    az = bz;
  }
  into[0] = nx;
  into[1] = ny;
  into[2] = nz;
}

class PolygonSplitter {
  /** Corners, three a triangle. */
  readonly triangles = new IndexList();
  roughFaces = 0;
  #budget = testBudget;
  readonly #positions: Float64Array;
  readonly #corners: Uint32Array;
  readonly #normal = new Float64Array(3);
  /** Corners of the current polygon in its plane, #n×2, counter-clockwise. */
  #flat = new Float64Array(64);

  constructor(positions: Float64Array, corners: Uint32Array) {
    this.#positions = positions;
    this.#corners = corners;
  }

  split(begin: number, end: number): void {
    const n = end - begin;
    if (n === 3 || !this.#flatten(begin, n) || this.#isConvex(n)) this.#fan(begin, n);
    else this.#clip(begin, n);
  }

  #triangle(begin: number, a: number, b: number, c: number): void {
    this.triangles.push3(begin + a, begin + b, begin + c);
  }

  #fan(begin: number, n: number): void {
    for (let i = 1; i + 1 < n; i++) this.#triangle(begin, 0, i, i + 1);
  }

  #clip(begin: number, n: number): void {
    const { triangles, tests, complete } = clipEars(this.#flat, n, this.#budget);
    this.#budget -= tests;
    if (!complete) this.roughFaces++;
    for (let t = 0; t < triangles.length; t += 3) {
      this.#triangle(begin, triangles[t], triangles[t + 1], triangles[t + 2]);
    }
  }

  /** Drops the coordinate along which the polygon is thinnest. False if it has no area. */
  #flatten(begin: number, n: number): boolean {
    newellVector(this.#positions, this.#corners, begin, begin + n, this.#normal);
    const [x, y, z] = this.#normal;
    const size = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
    if (!(size > 0) || size === Number.POSITIVE_INFINITY) return false;
    if (this.#flat.length < 2 * n) this.#flat = new Float64Array(4 * n);
    const drop = size === Math.abs(z) ? 2 : size === Math.abs(y) ? 1 : 0;
    const u = (drop + 1) % 3;
    const v = (drop + 2) % 3;
    const sign = this.#normal[drop] < 0 ? -1 : 1; // mirrors clockwise ones
    for (let i = 0; i < n; i++) {
      const p = 3 * this.#corners[begin + i];
      this.#flat[2 * i] = sign * this.#positions[p + u];
      this.#flat[2 * i + 1] = this.#positions[p + v];
    }
    return true;
  }

  /** Twice the signed area of a triangle of the flat polygon. */
  #area(a: number, b: number, c: number): number {
    const x = this.#flat;
    const ax = x[2 * a];
    const ay = x[2 * a + 1];
    return (x[2 * b] - ax) * (x[2 * c + 1] - ay) - (x[2 * b + 1] - ay) * (x[2 * c] - ax);
  }

  /** Left turns only, and once around: x changes direction twice. */
  #isConvex(n: number): boolean {
    let turns = 0;
    let direction = 0;
    for (let i = 0; i < n; i++) {
      const next = i + 1 === n ? 0 : i + 1;
      if (this.#area(i === 0 ? n - 1 : i - 1, i, next) < 0) return false;
      const step = Math.sign(this.#flat[2 * next] - this.#flat[2 * i]);
      if (step !== 0 && direction !== 0 && step !== direction) turns++;
      if (step !== 0) direction = step;
    }
    return turns <= 2;
  }
}
