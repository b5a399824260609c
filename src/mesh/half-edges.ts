/** The sides of faces, those of one edge beside each other. A side is named by the corner that it starts at. */
export interface HalfEdges {
  /** #F×3 */
  readonly triangles: Uint32Array;
  /** Corners; sides from a vertex to itself and sides to vertices that do not exist are left out. */
  readonly corners: Uint32Array;
  /** #E + 1, where the sides of each edge begin in `corners`. */
  readonly start: Uint32Array;
}

const nextCorner = (corner: number): number => (corner % 3 === 2 ? corner - 2 : corner + 1);
const lastCorner = (corner: number): number => (corner % 3 === 0 ? corner + 2 : corner - 1);

/** @param triangles #F×3   @param vertices #V */
export function halfEdgesOf(triangles: Uint32Array, vertices: number): HalfEdges {
  const passes = halfEdgePasses(triangles, vertices);
  for (;;) {
    const pass = passes.next();
    if (pass.done) return pass.value;
  }
}

/** The passes of {@link halfEdgesOf}, for those who must not stop for long: tens of milliseconds each at half a million faces. */
export function* halfEdgePasses(
  triangles: Uint32Array,
  vertices: number,
): Generator<void, HalfEdges, undefined> {
  const low = new Uint32Array(triangles.length);
  const high = new Uint32Array(triangles.length);
  const all = new Uint32Array(triangles.length);
  let count = 0;
  for (let c = 0; c < triangles.length; c++) {
    const v = triangles[c]!;
    const w = triangles[nextCorner(c)]!;
    low[c] = Math.min(v, w);
    high[c] = Math.max(v, w);
    if (v !== w && high[c]! < vertices) all[count++] = c;
  }
  yield;
  // Sorting by the second end, then by the first and keeping the order: linear, hubs of many edges included.
  const byHigh = countingSort(all.subarray(0, count), high, vertices);
  yield;
  const corners = countingSort(byHigh, low, vertices);
  yield;
  const start = new Uint32Array(count + 1);
  let edges = 0;
  for (let i = 0; i < count; i++) {
    const c = corners[i]!;
    const before = corners[i - 1]!;
    if (i === 0 || low[c] !== low[before] || high[c] !== high[before]) start[edges++] = i;
  }
  start[edges] = count;
  return { triangles, corners, start: start.subarray(0, edges + 1) };
}

/** @param keyOf key of each item, below `keys` */
function countingSort(items: Uint32Array, keyOf: Uint32Array, keys: number): Uint32Array {
  const next = new Uint32Array(keys + 1);
  for (let i = 0; i < items.length; i++) next[keyOf[items[i]!]! + 1]! += 1;
  for (let key = 0; key < keys; key++) next[key + 1]! += next[key]!;
  const sorted = new Uint32Array(items.length);
  for (let i = 0; i < items.length; i++) {
    const key = keyOf[items[i]!]!;
    sorted[next[key]!] = items[i]!;
    next[key]! += 1;
  }
  return sorted;
}

/**
 * Whether no edge has more than two faces, and two look the same way and are not the same face. Sides are filed by their lower
 * end only, which is all that this needs and a third of the work of {@link halfEdgesOf}.
 */
export function areSound(triangles: Uint32Array, vertices: number): boolean {
  const { start, corners } = sidesByLowerEnd(triangles, vertices);
  const seenAt = new Int32Array(vertices).fill(-1);
  const firstSide = new Uint32Array(vertices);
  const isPaired = new Uint8Array(vertices);
  for (let v = 0; v < vertices; v++) {
    for (let i = start[v]!; i < start[v + 1]!; i++) {
      const c = corners[i]!;
      const from = triangles[c]!;
      const other = from === v ? triangles[nextCorner(c)]! : from;
      if (seenAt[other] !== v) {
        seenAt[other] = v;
        firstSide[other] = c;
        isPaired[other] = 0;
        continue;
      }
      const first = firstSide[other]!;
      if (isPaired[other] === 1 || triangles[first] === from) return false;
      if (triangles[lastCorner(first)] === triangles[lastCorner(c)]) return false;
      isPaired[other] = 1;
    }
  }
  return true;
}

function sidesByLowerEnd(
  triangles: Uint32Array,
  vertices: number,
): { start: Uint32Array; corners: Uint32Array } {
  const start = new Uint32Array(vertices + 2);
  for (let c = 0; c < triangles.length; c++) {
    const [v, w] = [triangles[c]!, triangles[nextCorner(c)]!];
    if (v !== w && v < vertices && w < vertices) start[Math.min(v, w) + 2]! += 1;
  }
  for (let v = 0; v <= vertices; v++) start[v + 1]! += start[v]!;
  const corners = new Uint32Array(start[vertices + 1]!);
  for (let c = 0; c < triangles.length; c++) {
    const [v, w] = [triangles[c]!, triangles[nextCorner(c)]!];
    if (v === w || v >= vertices || w >= vertices) continue;
    const low = Math.min(v, w);
    corners[start[low + 1]!] = c;
    start[low + 1]! += 1;
  }
  return { start, corners };
}

/** The side across each corner's, #F×3, where an edge joins just two faces; 3·#F elsewhere. */
export function acrossCorners({ triangles, corners, start }: HalfEdges): Uint32Array {
  const across = new Uint32Array(triangles.length).fill(triangles.length);
  for (let edge = 0; edge + 1 < start.length; edge++) {
    if (start[edge + 1]! - start[edge]! !== 2) continue;
    const [a, b] = [corners[start[edge]!]!, corners[start[edge]! + 1]!];
    across[a] = b;
    across[b] = a;
  }
  return across;
}
