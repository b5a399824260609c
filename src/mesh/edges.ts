/** The edges of a triangle mesh, each once whatever the number and orientation of its faces. */
export interface Edges {
  /** #E×2 vertices. */
  readonly ends: Uint32Array<ArrayBuffer>;
  /** #E: how many faces meet there; 1 at a boundary. A face that uses a vertex twice may pass an edge twice. */
  readonly faces: Uint32Array<ArrayBuffer>;
}

/**
 * @param welded #F×3 faces in welded vertices, which decide what is the same edge
 * @param triangles #F×3 the same faces in source positions, which the ends are named in; or `welded` again
 * @param vertices #V
 */
export function edgesOf(welded: Uint32Array, triangles: Uint32Array, vertices: number): Edges {
  const start = bucketStarts(welded, vertices);
  const partner = new Uint32Array(welded.length);
  const edgeOf = new Uint32Array(welded.length);
  const filled = start.slice(0, vertices);
  const ends = new Uint32Array(2 * welded.length);
  const faces = new Uint32Array(welded.length);
  let count = 0;
  for (let corner = 0; corner < welded.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const low = Math.min(welded[corner]!, welded[next]!);
    const high = Math.max(welded[corner]!, welded[next]!);
    if (low === high) continue;
    const known = find(partner, start[low]!, filled[low]!, high);
    const edge = known < 0 ? count++ : edgeOf[known]!;
    faces[edge] = faces[edge]! + 1;
    if (known >= 0) continue;
    partner[filled[low]!] = high;
    edgeOf[filled[low]!] = edge;
    filled[low] = filled[low]! + 1;
    ends[2 * edge] = triangles[corner]!;
    ends[2 * edge + 1] = triangles[next]!;
  }
  return { ends: ends.slice(0, 2 * count), faces: faces.slice(0, count) };
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

/** Where a vertex stands in a part of a list; −1 if it does not. */
function find(partner: Uint32Array, from: number, to: number, vertex: number): number {
  for (let i = from; i < to; i++) if (partner[i] === vertex) return i;
  return -1;
}
