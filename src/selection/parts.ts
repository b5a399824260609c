import { type Labels, labelled } from './labels.ts';
import { otherEnd, type Topology } from './topology.ts';
import { pieceLength, type Work } from './work.ts';

/** The connected parts of a mesh, by vertices. A vertex that no face uses is a part of its own. */
export function* partsOf(topology: Topology): Work<Labels> {
  const { vertices, aroundStart, edgesAround } = topology;
  const partOf = new Uint32Array(vertices).fill(unseen);
  const waiting = new Uint32Array(vertices);
  let count = 0;
  let done = 0;
  for (let seed = 0; seed < vertices; seed++) {
    if (partOf[seed] !== unseen) continue;
    const part = count++;
    partOf[seed] = part;
    waiting[0] = seed;
    for (let size = 1; size > 0; ) {
      const v = waiting[--size]!;
      for (let i = aroundStart[v]!; i < aroundStart[v + 1]!; i++) {
        const w = otherEnd(topology, edgesAround[i]!, v);
        if (partOf[w] !== unseen) continue;
        partOf[w] = part;
        waiting[size++] = w;
      }
      if (++done % pieceLength === 0) yield;
    }
  }
  yield;
  return labelled(partOf, count);
}

const unseen = 0xffffffff;
