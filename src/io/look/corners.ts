import { IndexList } from '../lists.ts';
import { none, type Shape } from '../parsed-file.ts';

/** Vertices that have texture coordinates of their own: a position as often as it has different ones. */
export interface SplitVertices {
  /** #V: which position each of them is. */
  readonly positionOfVertex: Uint32Array;
  /** #V×2, v upward; NaN where a corner has none. */
  readonly uvs: Float32Array;
  /** #C: the vertex at each corner of the faces. */
  readonly vertexOfCorner: Uint32Array;
}

/** Splits positions where corners have different texture coordinates. The order of the positions stays. */
export function splitByUv(
  { positions, faces: { corners } }: Pick<Shape, 'positions' | 'faces'>,
  uvs: Float32Array,
): SplitVertices {
  const count = positions.length / 3;
  /** For each position its vertices so far, as a chain of corners that have them. */
  const first = new Uint32Array(count).fill(none);
  const next = new Uint32Array(corners.length).fill(none);
  const leader = new Uint32Array(corners.length);
  for (let c = 0; c < corners.length; c++) {
    let other = first[corners[c]];
    while (other !== none && !isSame(uvs, other, c)) other = next[other];
    leader[c] = other === none ? c : other;
    if (other !== none) continue;
    next[c] = first[corners[c]];
    first[corners[c]] = c;
  }
  return numbered(first, next, leader, uvs);
}

/** Numbers vertices by their positions; positions that no face uses have one too. */
function numbered(
  first: Uint32Array,
  next: Uint32Array,
  leader: Uint32Array,
  uvs: Float32Array,
): SplitVertices {
  const positionOfVertex = new IndexList();
  const uvOfVertex: number[] = [];
  const vertexOfLeader = new Uint32Array(leader.length);
  for (let p = 0; p < first.length; p++) {
    let corner = first[p];
    if (corner === none) uvOfVertex.push(Number.NaN, Number.NaN);
    if (corner === none) positionOfVertex.push(p);
    for (; corner !== none; corner = next[corner]) {
      vertexOfLeader[corner] = positionOfVertex.length;
      positionOfVertex.push(p);
      uvOfVertex.push(uvs[2 * corner], uvs[2 * corner + 1]);
    }
  }
  return {
    positionOfVertex: positionOfVertex.take(),
    uvs: Float32Array.from(uvOfVertex),
    vertexOfCorner: leader.map((corner) => vertexOfLeader[corner]),
  };
}

/** Whether two corners have the same texture coordinates; NaN equals NaN here. */
function isSame(uvs: Float32Array, a: number, b: number): boolean {
  return Object.is(uvs[2 * a], uvs[2 * b]) && Object.is(uvs[2 * a + 1], uvs[2 * b + 1]);
}
