/**
 * The edges of a triangle mesh, each once whatever the number and orientation of its faces.
 *
 * @param welded #F×3 faces in welded vertices, which decide what is the same edge
 * @param triangles #F×3 the same faces in source positions, which the answer is made of
 * @param vertices #V
 * @returns #E×2 indices of source positions
 */
export function uniqueEdges(
  welded: Uint32Array,
  triangles: Uint32Array,
  vertices: number,
): Uint32Array<ArrayBuffer> {
  const start = bucketStarts(welded, vertices);
  const partner = new Uint32Array(welded.length);
  const filled = start.slice(0, vertices);
  const edges = new Uint32Array(2 * welded.length);
  let count = 0;
  for (let corner = 0; corner < welded.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const low = Math.min(welded[corner]!, welded[next]!);
    const high = Math.max(welded[corner]!, welded[next]!);
    if (low === high || seen(partner, start[low]!, filled[low]!, high)) continue;
    partner[filled[low]!++] = high;
    edges[count++] = triangles[corner]!;
    edges[count++] = triangles[next]!;
  }
  return edges.slice(0, count);
}

/** Where the partners of each vertex begin when every half-edge is filed under its smaller vertex. */
function bucketStarts(welded: Uint32Array, vertices: number): Uint32Array<ArrayBuffer> {
  const start = new Uint32Array(vertices + 1);
  for (let corner = 0; corner < welded.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    start[Math.min(welded[corner]!, welded[next]!) + 1]!++;
  }
  for (let v = 0; v < vertices; v++) start[v + 1] = start[v + 1]! + start[v]!;
  return start;
}

function seen(partner: Uint32Array, from: number, to: number, vertex: number): boolean {
  for (let i = from; i < to; i++) if (partner[i] === vertex) return true;
  return false;
}
