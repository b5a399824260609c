import { halfEdgePasses } from '../mesh/half-edges.ts';
import type { Weld } from '../mesh/mesh.ts';
import { solvedTriangles } from '../mesh/weld.ts';
import { pieceLength, type Work } from './work.ts';

/** Who neighbours whom on a welded mesh, whatever the shape. Edges go by number, sides of faces by the corner they start at. */
export interface Topology {
  /** #V */
  readonly vertices: number;
  /** #S×3 welded vertices: the faces that the solver takes. */
  readonly triangles: Uint32Array;
  /** #E×2 vertices, the smaller first. */
  readonly ends: Uint32Array;
  /** #S×3, the edge of each side; `none` for the side of a face that uses a vertex twice. */
  readonly edgeOfSide: Uint32Array;
  /** #E + 1, where the sides of each edge begin in `sides`. */
  readonly sideStart: Uint32Array;
  readonly sides: Uint32Array;
  /** #V + 1, where the edges around each vertex begin in `edgesAround`. */
  readonly aroundStart: Uint32Array;
  readonly edgesAround: Uint32Array;
}

/** In place of an edge, where there is none. */
export const none = 0xffffffff;

export const nextSide = (side: number): number => (side % 3 === 2 ? side - 2 : side + 1);
export const faceOfSide = (side: number): number => Math.floor(side / 3);

export const edgeCount = ({ ends }: Topology): number => ends.length / 2;
export const faceCount = ({ triangles }: Topology): number => triangles.length / 3;

/** How many sides an edge has: 1 at a border, 2 inside a surface, more where surfaces meet. */
export const sidesOf = ({ sideStart }: Topology, edge: number): number =>
  sideStart[edge + 1]! - sideStart[edge]!;

/** The side across; `none` where an edge does not join just two faces. */
export function sideAcross(topology: Topology, side: number): number {
  const edge = topology.edgeOfSide[side]!;
  if (edge === none || sidesOf(topology, edge) !== 2) return none;
  const first = topology.sides[topology.sideStart[edge]!]!;
  return first === side ? topology.sides[topology.sideStart[edge]! + 1]! : first;
}

/** The other end of an edge. */
export function otherEnd({ ends }: Topology, edge: number, vertex: number): number {
  return ends[2 * edge] === vertex ? ends[2 * edge + 1]! : ends[2 * edge]!;
}

export function* topologyOf(weld: Weld): Work<Topology> {
  const vertices = weld.positionOfVertex.length;
  const triangles = solvedTriangles(weld);
  const { start: sideStart, corners: sides } = yield* halfEdgePasses(triangles, vertices);
  yield;
  const edges = sideStart.length - 1;
  const ends = new Uint32Array(2 * edges);
  const edgeOfSide = new Uint32Array(triangles.length).fill(none);
  for (let edge = 0; edge < edges; edge++) {
    const first = sides[sideStart[edge]!]!;
    const v = triangles[first]!;
    const w = triangles[nextSide(first)]!;
    ends[2 * edge] = Math.min(v, w);
    ends[2 * edge + 1] = Math.max(v, w);
    for (let i = sideStart[edge]!; i < sideStart[edge + 1]!; i++) edgeOfSide[sides[i]!] = edge;
    if (edge % pieceLength === 0) yield;
  }
  const { start, members } = yield* around(ends, vertices);
  return {
    vertices,
    triangles,
    ends,
    edgeOfSide,
    sideStart,
    sides,
    aroundStart: start,
    edgesAround: members,
  };
}

function* around(ends: Uint32Array, vertices: number): Work<{ start: Uint32Array; members: Uint32Array }> {
  const next = new Uint32Array(vertices + 2);
  for (let i = 0; i < ends.length; i++) next[ends[i]! + 2]! += 1;
  for (let v = 0; v <= vertices; v++) next[v + 1]! += next[v]!;
  yield;
  const members = new Uint32Array(ends.length);
  for (let i = 0; i < ends.length; i++) {
    const v = ends[i]! + 1;
    members[next[v]!] = i >> 1;
    next[v]! += 1;
    if (i % pieceLength === 0) yield;
  }
  return { start: next.subarray(0, vertices + 1), members };
}
