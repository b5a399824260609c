import type { Selection } from './selection.ts';
import { faceCount, type Topology } from './topology.ts';

/** How a set of vertices is shown: faces that are whole in it, and what of it no such face has. */
export interface DrawnSelection {
  /** Of the faces that the solver takes. */
  readonly faces: Uint32Array;
  /** #×2 welded vertices. */
  readonly edges: Uint32Array;
  /** Those that are on none of the faces. */
  readonly vertices: Uint32Array;
}

export function drawnOf({ marks }: Selection, topology: Topology): DrawnSelection {
  const { triangles } = topology;
  const faces = new Uint32Array(faceCount(topology));
  const isShown = new Uint8Array(marks.length);
  let count = 0;
  for (let face = 0; face < faces.length; face++) {
    const a = triangles[3 * face]!;
    const b = triangles[3 * face + 1]!;
    const c = triangles[3 * face + 2]!;
    if (marks[a] === 0 || marks[b] === 0 || marks[c] === 0) continue;
    faces[count++] = face;
    isShown[a] = isShown[b] = isShown[c] = 1;
  }
  const vertices: number[] = [];
  for (let v = 0; v < marks.length; v++) if (marks[v] === 1 && isShown[v] === 0) vertices.push(v);
  return {
    faces: faces.slice(0, count),
    edges: bareEdges(marks, topology, vertices, isShown),
    vertices: Uint32Array.from(vertices),
  };
}

/** Edges between marked vertices that are no side of a face that is whole; those between two faces' vertices do not show anyway. */
function bareEdges(
  marks: Uint8Array,
  topology: Topology,
  vertices: readonly number[],
  isShown: Uint8Array,
): Uint32Array {
  const { ends, aroundStart, edgesAround } = topology;
  const found: number[] = [];
  for (const v of vertices) {
    for (let i = aroundStart[v]!; i < aroundStart[v + 1]!; i++) {
      const edge = edgesAround[i]!;
      const [a, b] = [ends[2 * edge]!, ends[2 * edge + 1]!];
      const other = a === v ? b : a;
      // An edge between two bare vertices is met twice.
      if (marks[other] === 1 && (isShown[other] === 1 || v < other)) found.push(a, b);
    }
  }
  return Uint32Array.from(found);
}
