import { dot, row, subtract, unit, type Vec3 } from '../mesh/vectors.ts';
import { border, smooth } from './features.ts';
import type { SelectableMesh } from './selectable.ts';
import { edgeCount, faceOfSide, none, otherEnd, sideAcross } from './topology.ts';

/** Where two feature edges meet, a line that turns by more than 60° has a corner; where several meet, one that turns by more than 30°. */
const leastCosineOfTwo = Math.cos(Math.PI / 3);
const leastCosineOfMany = Math.cos(Math.PI / 6);

/** The edges of the line that a feature edge lies on: straight on through vertices, both ways, up to corners or all around. */
export function featureLoop(surface: SelectableMesh, edge: number): Uint32Array {
  const [a, b] = endsOf(surface, edge);
  const line = new Set([edge]);
  follow(surface, line, edge, b, straightOn);
  follow(surface, line, edge, a, straightOn);
  return Uint32Array.from(line);
}

/** The edges of the border that an edge with one face lies on: the rim of one opening, all around. */
export function boundaryLoop(surface: SelectableMesh, edge: number): Uint32Array {
  const [a, b] = endsOf(surface, edge);
  const rim = new Set([edge]);
  follow(surface, rim, edge, b, alongBorder);
  // What is not a simple rim ends somewhere.
  follow(surface, rim, edge, a, alongBorder);
  return Uint32Array.from(rim);
}

type Next = (surface: SelectableMesh, edge: number, vertex: number) => number;

function follow(surface: SelectableMesh, line: Set<number>, from: number, end: number, next: Next): void {
  let edge = from;
  let vertex = end;
  for (let left = edgeCount(surface.topology); left > 0; left--) {
    edge = next(surface, edge, vertex);
    if (edge === none || line.has(edge)) return;
    line.add(edge);
    vertex = otherEnd(surface.topology, edge, vertex);
  }
}

/** The feature edge that goes on from another at a vertex; `none` at a corner. */
function straightOn(surface: SelectableMesh, edge: number, vertex: number): number {
  const others = featuresAround(surface, vertex).filter((other) => other !== edge);
  if (others.length === 0) return none;
  const cosines = others.map((other) => -bend(surface, vertex, edge, other));
  const best = cosines.indexOf(Math.max(...cosines));
  return cosines[best]! >= (others.length === 1 ? leastCosineOfTwo : leastCosineOfMany)
    ? others[best]!
    : none;
}

/** The cosine between two edges, both seen from the vertex that they share. */
function bend(surface: SelectableMesh, vertex: number, edge: number, other: number): number {
  return dot(directionFrom(surface, vertex, edge), directionFrom(surface, vertex, other));
}

function directionFrom({ topology, places }: SelectableMesh, vertex: number, edge: number): Vec3 {
  return unit(subtract(row(places, otherEnd(topology, edge, vertex)), row(places, vertex)));
}

/** The border edge that goes on at a vertex, around the faces between: sheets that touch in one vertex keep their rims apart. */
function alongBorder({ topology, features }: SelectableMesh, edge: number, vertex: number): number {
  let side = topology.sides[topology.sideStart[edge]!]!;
  for (let left = topology.triangles.length; left > 0; left--) {
    side = otherSideAt(topology.triangles, side, vertex);
    const at = topology.edgeOfSide[side]!;
    if (at === none || features[at] === border) return at;
    side = sideAcross(topology, side);
    if (side === none) return none;
  }
  return none;
}

/** The other side of a face that has the vertex as an end. */
function otherSideAt(triangles: Uint32Array, side: number, vertex: number): number {
  const first = 3 * faceOfSide(side);
  const at = side - first;
  return triangles[side] === vertex ? first + ((at + 2) % 3) : first + ((at + 1) % 3);
}

/** Edges at a vertex that are not smooth. */
export function featuresAround({ topology, features }: SelectableMesh, vertex: number): number[] {
  const found: number[] = [];
  for (let i = topology.aroundStart[vertex]!; i < topology.aroundStart[vertex + 1]!; i++) {
    const edge = topology.edgesAround[i]!;
    if (features[edge] !== smooth) found.push(edge);
  }
  return found;
}

function endsOf({ topology: { ends } }: SelectableMesh, edge: number): [number, number] {
  return [ends[2 * edge]!, ends[2 * edge + 1]!];
}
