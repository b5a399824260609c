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
  const low = (c: number): number => Math.min(triangles[c]!, triangles[nextCorner(c)]!);
  const high = (c: number): number => Math.max(triangles[c]!, triangles[nextCorner(c)]!);
  const all = Uint32Array.from(triangles.keys()).filter((c) => low(c) !== high(c) && high(c) < vertices);
  // Sorting by the second end, then by the first and keeping the order: linear, hubs of many edges included.
  const corners = countingSort(countingSort(all, high, vertices), low, vertices);
  const start = new Uint32Array(corners.length + 1);
  let edges = 0;
  for (let i = 0; i < corners.length; i++) {
    const isNew =
      i === 0 || low(corners[i]!) !== low(corners[i - 1]!) || high(corners[i]!) !== high(corners[i - 1]!);
    if (isNew) start[edges++] = i;
  }
  start[edges] = corners.length;
  return { triangles, corners, start: start.subarray(0, edges + 1) };
}

function countingSort(items: Uint32Array, keyOf: (item: number) => number, keys: number): Uint32Array {
  const next = new Uint32Array(keys + 1);
  for (const item of items) next[keyOf(item) + 1]! += 1;
  for (let key = 0; key < keys; key++) next[key + 1]! += next[key]!;
  const sorted = new Uint32Array(items.length);
  for (const item of items) sorted[next[keyOf(item)]!++] = item;
  return sorted;
}

/** Whether no edge has more than two faces, and two look the same way and are not the same face. */
export function isSound({ triangles, corners, start }: HalfEdges): boolean {
  for (let edge = 0; edge + 1 < start.length; edge++) {
    const count = start[edge + 1]! - start[edge]!;
    if (count === 1) continue;
    const [a, b] = [corners[start[edge]!]!, corners[start[edge]! + 1]!];
    if (count > 2 || triangles[a] === triangles[b]) return false;
    if (triangles[lastCorner(a)] === triangles[lastCorner(b)]) return false;
  }
  return true;
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
