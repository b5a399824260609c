import { extentOf } from './extent.ts';

/** Places that are nearer than this share of the diagonal may be one place, written down with few digits. */
const rounding = 5e-5;
/** Nearer than this, what single precision leaves of one place, they are one wherever they are; else only on open borders. */
const singlePrecision = 1e-6;
/** Squares of lengths must not overflow. */
const mostDiagonal = 1e150;
/** Of the shortest edge at a place, the share within which nothing else belongs to the shape. */
const ofShortestEdge = 0.2;

/**
 * Which vertices are one place but for rounding.
 *
 * Two are if they are nearer than {@link rounding}, and much nearer than the next vertex of their faces, so that no edge ever
 * collapses. Beyond single precision both must lie on open borders, as the sides of a seam do, and no vertex within the surface
 * beside them may have another as near: two sheets so near each other have a real distance. What is joined lies in a box of
 * that size as a whole. None of it depends on the order of vertices, but where distances are equal.
 *
 * @param positions #V×3, no two equal
 * @param triangles #F×3; corners that do not exist count for nothing
 * @returns for each vertex the first that is in its place, #V; undefined where all stay by themselves
 */
export function joinNearPlaces(positions: Float64Array, triangles: Uint32Array): Uint32Array | undefined {
  const { diagonal } = extentOf(positions, triangles);
  if (!(diagonal > 0 && diagonal < mostDiagonal)) return undefined;
  const reach = reaches(positions, triangles, rounding * diagonal);
  const pairs = nearPairs(positions, reach, rounding * diagonal);
  if (pairs.length === 0) return undefined;
  const joined = plausible(pairs, positions, triangles, singlePrecision * diagonal);
  return joined.length === 0 ? undefined : clusters(joined, positions, reach);
}

/** How far from each vertex another may be the same place; 0 for those without a face. */
function reaches(positions: Float64Array, triangles: Uint32Array, most: number): Float64Array {
  const count = positions.length / 3;
  const shortest = new Float64Array(count).fill(-1);
  for (let c = 0; c < triangles.length; c++) {
    const v = triangles[c]!;
    const w = triangles[c % 3 === 2 ? c - 2 : c + 1]!;
    if (v === w || v >= count || w >= count) continue;
    const square = squaredDistance(positions, v, w);
    if (!(square >= shortest[v]! && shortest[v]! >= 0)) shortest[v] = square;
    if (!(square >= shortest[w]! && shortest[w]! >= 0)) shortest[w] = square;
  }
  for (let v = 0; v < count; v++)
    shortest[v] = shortest[v]! > 0 ? Math.min(most, ofShortestEdge * Math.sqrt(shortest[v]!)) : 0;
  return shortest;
}

/** Pairs of vertices that are within reach of each other, two entries a pair. */
function nearPairs(positions: Float64Array, reach: Float64Array, most: number): number[] {
  const grid = new LevelGrid(positions, reach, most);
  const pairs: number[] = [];
  for (let v = 0; v < reach.length; v++) {
    if (reach[v] === 0) continue;
    grid.collectNear(v, pairs);
    grid.add(v);
  }
  return pairs;
}

/**
 * Vertices by cells of space. Each is in the grid of its own reach, the finest that is no finer: cells then hold few, for what
 * reaches far lies far from its neighbours.
 */
class LevelGrid {
  readonly #positions: Float64Array;
  readonly #reach: Float64Array;
  readonly #most: number;
  readonly #heads: Int32Array;
  readonly #next: Int32Array;
  /** Those that hold anything. */
  readonly #levels: number[] = [];

  constructor(positions: Float64Array, reach: Float64Array, most: number) {
    this.#positions = positions;
    this.#reach = reach;
    this.#most = most;
    this.#heads = new Int32Array(2 ** Math.ceil(Math.log2(2 * reach.length + 2))).fill(-1);
    this.#next = new Int32Array(reach.length);
  }

  add(v: number): void {
    const level = this.#levelOf(this.#reach[v]!);
    if (!this.#levels.includes(level)) this.#levels.push(level);
    const x = this.#positions;
    const cells = 1 / this.#cellSize(level);
    if (!this.#isResolved(v, cells)) return;
    const bucket = this.#bucket(
      level,
      Math.floor(x[3 * v]! * cells),
      Math.floor(x[3 * v + 1]! * cells),
      Math.floor(x[3 * v + 2]! * cells),
    );
    this.#next[v] = this.#heads[bucket]!;
    this.#heads[bucket] = v;
  }

  /** Appends the pairs of a vertex with those that were added before; some may come twice. */
  collectNear(v: number, pairs: number[]): void {
    const positions = this.#positions;
    const [x, y, z] = [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
    for (const level of this.#levels) {
      const cells = 1 / this.#cellSize(level);
      if (!this.#isResolved(v, cells)) continue;
      const radius = Math.min(this.#reach[v]!, this.#most / 4 ** level);
      const lastI = Math.floor((x + radius) * cells);
      const lastJ = Math.floor((y + radius) * cells);
      const lastK = Math.floor((z + radius) * cells);
      for (let i = Math.floor((x - radius) * cells); i <= lastI; i++)
        for (let j = Math.floor((y - radius) * cells); j <= lastJ; j++)
          for (let k = Math.floor((z - radius) * cells); k <= lastK; k++)
            this.#collectOf(this.#bucket(level, i, j, k), v, pairs);
    }
  }

  #collectOf(bucket: number, v: number, pairs: number[]): void {
    for (let u = this.#heads[bucket]!; u >= 0; u = this.#next[u]!) {
      const limit = Math.min(this.#reach[u]!, this.#reach[v]!);
      if (squaredDistance(this.#positions, u, v) <= limit * limit) pairs.push(u, v);
    }
  }

  /** Whether the numbers of a vertex have digits left for cells so fine. */
  #isResolved(v: number, cells: number): boolean {
    const x = this.#positions;
    return Math.max(Math.abs(x[3 * v]!), Math.abs(x[3 * v + 1]!), Math.abs(x[3 * v + 2]!)) * cells < 2 ** 50;
  }

  #levelOf(reach: number): number {
    return reach === this.#most ? 0 : Math.max(0, Math.floor(Math.log2(this.#most / reach) / 2));
  }

  #cellSize(level: number): number {
    return (8 * this.#most) / 4 ** level;
  }

  #bucket(level: number, i: number, j: number, k: number): number {
    let hash = Math.imul(i, 0x9e3779b1) ^ level;
    hash = Math.imul(hash ^ (hash >>> 15) ^ j, 0x85ebca6b);
    hash = Math.imul(hash ^ (hash >>> 13) ^ k, 0xc2b2ae35);
    return (hash ^ (hash >>> 16)) & (this.#heads.length - 1);
  }
}

/** The pairs that are one place by all that lies around them. */
function plausible(
  pairs: number[],
  positions: Float64Array,
  triangles: Uint32Array,
  singlePrecision: number,
): number[] {
  const isTiny = (i: number): boolean =>
    squaredDistance(positions, pairs[i]!, pairs[i + 1]!) <= singlePrecision * singlePrecision;
  const openness = openBorders(triangles, positions.length / 3);
  const isBesideSheet = new Uint8Array(openness.length);
  for (let i = 0; i < pairs.length; i += 2) {
    if (isTiny(i)) continue;
    for (const v of [pairs[i]!, pairs[i + 1]!]) if (openness[v] === 0) isBesideSheet[v] = 1;
  }
  // Twice: a jagged rim has faces whose corners are all on it.
  for (let ring = 0; ring < 2; ring++) spreadOverFaces(isBesideSheet, triangles);
  return pairs.filter((_, entry) => {
    const i = entry - (entry % 2);
    const [v, w] = [pairs[i]!, pairs[i + 1]!];
    if (isTiny(i)) return true;
    return openness[v] !== 0 && openness[w] !== 0 && isBesideSheet[v] === 0 && isBesideSheet[w] === 0;
  });
}

/**
 * Not zero for vertices on open borders, #V: around all others every edge is passed both ways, so that sums of (scrambled)
 * numbers of the ends cancel.
 */
function openBorders(triangles: Uint32Array, count: number): Int32Array {
  const openness = new Int32Array(count);
  for (let c = 0; c < triangles.length; c++) {
    const v = triangles[c]!;
    const next = triangles[c % 3 === 2 ? c - 2 : c + 1]!;
    const last = triangles[c % 3 === 0 ? c + 2 : c - 1]!;
    if (v < count) openness[v] = openness[v]! + scrambled(next) - scrambled(last);
  }
  return openness;
}

function scrambled(v: number): number {
  const mixed = Math.imul(v ^ (v >>> 16), 0x45d9f3b);
  return Math.imul(mixed ^ (mixed >>> 15), 0x2c1b3c6d) >> 8;
}

/** Marks all corners of faces that have a marked one. */
function spreadOverFaces(marks: Uint8Array, triangles: Uint32Array): void {
  const marked = marks.slice();
  for (let c = 0; c < triangles.length; c += 3) {
    const corners = triangles.subarray(c, c + 3);
    if (corners.some((v) => marked[v] === 1)) for (const v of corners) if (v < marks.length) marks[v] = 1;
  }
}

/** Joins pairs to clusters that lie in a box no longer than the least reach in them, nearest pairs first. */
function clusters(pairs: number[], positions: Float64Array, reach: Float64Array): Uint32Array {
  const whole = new Clusters(positions, reach);
  for (let i = 0; i < pairs.length; i += 2) whole.join(pairs[i]!, pairs[i + 1]!);
  // A chain of near places may be longer than they reach; only those have to be taken one by one.
  const tooLong: { distance: number; v: number; w: number }[] = [];
  const result = new Clusters(positions, reach);
  for (let i = 0; i < pairs.length; i += 2) {
    const [v, w] = [pairs[i]!, pairs[i + 1]!];
    if (whole.isTight(v)) result.join(v, w);
    else tooLong.push({ distance: squaredDistance(positions, v, w), v, w });
  }
  tooLong.sort((a, b) => a.distance - b.distance);
  for (const { v, w } of tooLong) if (result.wouldBeTight(v, w)) result.join(v, w);
  return result.firsts();
}

/** Sets of vertices, each with its box and its least reach. */
class Clusters {
  readonly #parent: Uint32Array;
  readonly #low: Float64Array;
  readonly #high: Float64Array;
  readonly #reach: Float64Array;

  constructor(positions: Float64Array, reach: Float64Array) {
    this.#parent = Uint32Array.from(reach.keys());
    this.#low = positions.slice();
    this.#high = positions.slice();
    this.#reach = reach.slice();
  }

  join(v: number, w: number): void {
    const [a, b] = [this.#root(v), this.#root(w)];
    if (a === b) return;
    const [first, second] = a < b ? [a, b] : [b, a];
    this.#parent[second] = first;
    this.#reach[first] = Math.min(this.#reach[first]!, this.#reach[second]!);
    for (let axis = 0; axis < 3; axis++) {
      const [i, j] = [3 * first + axis, 3 * second + axis];
      this.#low[i] = Math.min(this.#low[i]!, this.#low[j]!);
      this.#high[i] = Math.max(this.#high[i]!, this.#high[j]!);
    }
  }

  isTight(v: number): boolean {
    return this.wouldBeTight(v, v);
  }

  wouldBeTight(v: number, w: number): boolean {
    const [a, b] = [this.#root(v), this.#root(w)];
    let square = 0;
    for (let axis = 0; axis < 3; axis++) {
      const [i, j] = [3 * a + axis, 3 * b + axis];
      square += (Math.max(this.#high[i]!, this.#high[j]!) - Math.min(this.#low[i]!, this.#low[j]!)) ** 2;
    }
    return square <= Math.min(this.#reach[a]!, this.#reach[b]!) ** 2;
  }

  /** The first vertex of each vertex' cluster. */
  firsts(): Uint32Array {
    return this.#parent.map((_, v) => this.#root(v));
  }

  #root(v: number): number {
    let root = v;
    while (this.#parent[root] !== root) root = this.#parent[root]!;
    // Whoever asks next has a short way.
    for (let at = v; at !== root; ) {
      const up = this.#parent[at]!;
      this.#parent[at] = root;
      at = up;
    }
    return root;
  }
}

function squaredDistance(x: Float64Array, v: number, w: number): number {
  return (
    (x[3 * v]! - x[3 * w]!) ** 2 + (x[3 * v + 1]! - x[3 * w + 1]!) ** 2 + (x[3 * v + 2]! - x[3 * w + 2]!) ** 2
  );
}
