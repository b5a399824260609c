import { dot, doubledAreaVector, row, subtract, unit, type Vec3 } from '../mesh/vectors.ts';
import { smooth } from './features.ts';
import { featureLoop } from './loops.ts';
import { type Aim, nearestFeature, nearestSide } from './near-pointer.ts';
import type { SelectableMesh } from './selectable.ts';
import { edgeCount, faceOfSide, none, otherEnd, sidesOf, type Topology } from './topology.ts';

/** What a line along edges is wanted for. */
export type LinePurpose = 'crease' | 'smooth' | 'straight';

/** Edges in a row. */
export interface Line {
  /** Welded vertices from one to the next; the first again at the end of one that goes all around. */
  readonly vertices: readonly number[];
  readonly edges: Uint32Array;
}

/** Degrees by which a line that is to be straight turns at a vertex, at most. */
const straightTurn = 10;
/** Degrees by which a line along a gentle bend of the surface turns at a vertex, at most. */
const bendTurn = 30;
/** Degrees by which a surface bends at least where a bend can be followed. */
const leastBend = 5;
/** A bend goes on where the surface bends by this share of what it does at its begin. */
const bendShare = 0.5;

/**
 * The line that a person means who points there. A crease that is there already goes from corner to corner; so does a gentler bend of
 * the surface that is to become one; a straight line goes as far as edges go straight on. Null where nothing near can be meant: what
 * is smooth already cannot be made so.
 */
export function lineAt(surface: SelectableMesh, aim: Aim, purpose: LinePurpose): Line | null {
  const near = nearestFeature(surface, aim);
  const edge = near?.edge ?? (purpose === 'smooth' ? none : nearestSide(surface, aim));
  if (edge === none) return null;
  const edges = near && purpose !== 'straight' ? featureLoop(surface, edge) : goneOn(surface, edge, purpose);
  return { vertices: inARow(surface.topology, edges), edges };
}

/** Where a line goes on from an edge, both ways. */
function goneOn(surface: SelectableMesh, edge: number, purpose: LinePurpose): Uint32Array {
  const isFeature = surface.features[edge] !== smooth;
  const bend = bendOf(surface, edge);
  const isBend = purpose === 'crease' && bend >= leastBend;
  const least = Math.cos(((isBend ? bendTurn : straightTurn) * Math.PI) / 180);
  const goes = (other: number): boolean => {
    if (isFeature) return surface.features[other] !== smooth;
    return !isBend || bendOf(surface, other) >= bendShare * bend;
  };
  const line = new Set([edge]);
  const { ends } = surface.topology;
  for (const end of [ends[2 * edge + 1]!, ends[2 * edge]!]) {
    let [at, vertex] = [edge, end];
    for (let left = edgeCount(surface.topology); left > 0; left--) {
      at = straightest(surface, at, vertex, goes, least);
      if (at === none || line.has(at)) break;
      line.add(at);
      vertex = otherEnd(surface.topology, at, vertex);
    }
  }
  return Uint32Array.from(line);
}

/** Of the edges at a vertex the one that goes on straightest from another; `none` where all turn more than they may. */
function straightest(
  surface: SelectableMesh,
  edge: number,
  vertex: number,
  goes: (edge: number) => boolean,
  least: number,
): number {
  const { aroundStart, edgesAround } = surface.topology;
  const back = directionFrom(surface, vertex, edge);
  let [best, straightness] = [none, least];
  for (let i = aroundStart[vertex]!; i < aroundStart[vertex + 1]!; i++) {
    const other = edgesAround[i]!;
    if (other === edge || !goes(other)) continue;
    const cosine = -dot(back, directionFrom(surface, vertex, other));
    if (cosine >= straightness) [best, straightness] = [other, cosine];
  }
  return best;
}

function directionFrom({ topology, places }: SelectableMesh, vertex: number, edge: number): Vec3 {
  return unit(subtract(row(places, otherEnd(topology, edge, vertex)), row(places, vertex)));
}

/** Degrees by which the surface bends at an edge; 0 where there are not just two faces. */
function bendOf({ topology, places }: SelectableMesh, edge: number): number {
  if (sidesOf(topology, edge) !== 2) return 0;
  const first = topology.sideStart[edge]!;
  const [a, b] = [0, 1].map((k) => {
    const face = faceOfSide(topology.sides[first + k]!);
    const [p, q, r] = [0, 1, 2].map((corner) => row(places, topology.triangles[3 * face + corner]!));
    return unit(doubledAreaVector(p!, q!, r!));
  });
  return (Math.acos(Math.max(-1, Math.min(1, dot(a!, b!)))) * 180) / Math.PI;
}

/** The vertices of a line in a row, given its edges in any order. */
export function inARow(topology: Topology, edges: Uint32Array): number[] {
  const around = new Map<number, number[]>();
  const endsOf = (edge: number) => [topology.ends[2 * edge]!, topology.ends[2 * edge + 1]!] as const;
  for (const edge of edges) {
    for (const vertex of endsOf(edge)) {
      const meeting = around.get(vertex) ?? [];
      meeting.push(edge);
      around.set(vertex, meeting);
    }
  }
  let vertex = [...around].find(([, meeting]) => meeting.length === 1)?.[0] ?? endsOf(edges[0]!)[0];
  const vertices = [vertex];
  const left = new Set(edges);
  for (;;) {
    const next = around.get(vertex)!.find((edge) => left.has(edge));
    if (next === undefined) return vertices;
    left.delete(next);
    vertex = otherEnd(topology, next, vertex);
    vertices.push(vertex);
  }
}
