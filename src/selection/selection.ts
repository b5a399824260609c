import { otherEnd, type Topology } from './topology.ts';

/** Some vertices of a mesh. Immutable: every operation makes another. */
export interface Selection {
  /** #V, 1 for each welded vertex that is selected. */
  readonly marks: Uint8Array<ArrayBuffer>;
  readonly count: number;
}

/** What becomes of what is selected already: it goes, it stays, or it loses what is chosen now. */
export type Combination = 'replace' | 'add' | 'remove';

/** @param vertices #V */
export const nothing = (vertices: number): Selection => ({ marks: new Uint8Array(vertices), count: 0 });

/** @param vertices #V */
export const everything = (vertices: number): Selection => ({
  marks: new Uint8Array(vertices).fill(1),
  count: vertices,
});

/** Welded vertices put to others. */
export function combined(
  { marks, count }: Selection,
  vertices: Iterable<number>,
  how: Combination,
): Selection {
  const next = how === 'replace' ? new Uint8Array(marks.length) : marks.slice();
  let changed = how === 'replace' ? 0 : count;
  const value = how === 'remove' ? 0 : 1;
  for (const v of vertices) {
    changed += value - next[v]!;
    next[v] = value;
  }
  return { marks: next, count: changed };
}

export function inverted({ marks, count }: Selection): Selection {
  return { marks: marks.map((mark) => 1 - mark), count: marks.length - count };
}

/** With all neighbours. */
export function grown(selection: Selection, topology: Topology): Selection {
  const { marks } = selection;
  const next = marks.slice();
  let { count } = selection;
  eachEdge(topology, (v, w) => {
    if (marks[v] === marks[w]) return;
    const outside = marks[v] === 1 ? w : v;
    count += 1 - next[outside]!;
    next[outside] = 1;
  });
  return { marks: next, count };
}

/** Without those that have a neighbour outside. A part that is selected as a whole stays. */
export function shrunk(selection: Selection, topology: Topology): Selection {
  return inverted(grown(inverted(selection), topology));
}

/** The vertices that are selected, rising. */
export function selectedVertices({ marks, count }: Selection): Uint32Array<ArrayBuffer> {
  const vertices = new Uint32Array(count);
  let at = 0;
  for (let v = 0; v < marks.length; v++) if (marks[v] === 1) vertices[at++] = v;
  return vertices;
}

/** How a selection falls into pieces that touch: whoever moves it may care that there are two ears in it. */
export function piecesOf({ marks }: Selection, topology: Topology): Uint32Array[] {
  const isSeen = new Uint8Array(marks.length);
  const pieces: Uint32Array[] = [];
  for (let seed = 0; seed < marks.length; seed++) {
    if (marks[seed] === 0 || isSeen[seed] === 1) continue;
    const piece = [seed];
    isSeen[seed] = 1;
    for (let at = 0; at < piece.length; at++) {
      const v = piece[at]!;
      for (let i = topology.aroundStart[v]!; i < topology.aroundStart[v + 1]!; i++) {
        const w = otherEnd(topology, topology.edgesAround[i]!, v);
        if (marks[w] === 0 || isSeen[w] === 1) continue;
        isSeen[w] = 1;
        piece.push(w);
      }
    }
    pieces.push(Uint32Array.from(piece));
  }
  return pieces;
}

function eachEdge({ ends }: Topology, visit: (v: number, w: number) => void): void {
  for (let i = 0; i < ends.length; i += 2) visit(ends[i]!, ends[i + 1]!);
}
