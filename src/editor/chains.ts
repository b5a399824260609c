import type { Mesh } from '../mesh/mesh.ts';
import { weldOf } from '../mesh/weld.ts';
import type { Chains } from '../methods/values/chains.ts';

/** Changes of lines along edges, each a new list. An edge is in one of them at most. */

/** Adds a line, last; those that have some of its edges lose them to it. @param chain positions of the file */
export function withChain(chains: Chains, mesh: Mesh, chain: readonly number[]): Chains {
  return [...withoutChain(chains, mesh, chain), chain];
}

/** Takes the edges of a line out of all that have them; what is left of a line on both sides of a gap are two. */
export function withoutChain(chains: Chains, mesh: Mesh, gone: readonly number[]): Chains {
  const key = edgeKeys(mesh);
  const isGone = new Set(edgesOf(gone).map(key));
  if (!chains.some((chain) => edgesOf(chain).some((edge) => isGone.has(key(edge))))) return chains;
  return chains.flatMap((chain) => cut(chain, (edge) => isGone.has(key(edge))));
}

/** Whether lines have all edges of another. */
export function hasChain(chains: Chains, mesh: Mesh, chain: readonly number[]): boolean {
  const key = edgeKeys(mesh);
  const known = new Set(chains.flatMap((one) => edgesOf(one).map(key)));
  return edgesOf(chain).every((edge) => known.has(key(edge)));
}

type Edge = readonly [from: number, to: number];

/** The steps of a line. */
export function edgesOf(chain: readonly number[]): Edge[] {
  return chain.slice(1).map((to, k) => [chain[k]!, to]);
}

function cut(chain: readonly number[], isGone: (edge: Edge) => boolean): number[][] {
  const pieces: number[][] = [];
  let piece: number[] = [];
  for (const [from, to] of edgesOf(chain)) {
    if (isGone([from, to])) {
      pieces.push(piece);
      piece = [];
    } else if (piece.length > 0) piece.push(to);
    else piece = [from, to];
  }
  return [...pieces, piece].filter(({ length }) => length > 1);
}

/** A key for the place of an edge, whichever way it goes and however often the file stores it. */
function edgeKeys(mesh: Mesh): (edge: Edge) => string {
  const { vertexOfPosition } = weldOf(mesh);
  return ([from, to]) => {
    const [a, b] = [vertexOfPosition[from]!, vertexOfPosition[to]!];
    return a < b ? `${a} ${b}` : `${b} ${a}`;
  };
}
