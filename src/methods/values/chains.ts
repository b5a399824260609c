import { WhittleError } from '../../mesh/failure.ts';
import { type Encoded, noNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { verticesProblem } from './points.ts';
import { show } from './show.ts';

/**
 * Lines along edges of the mesh: each a list of vertices (indices of the source file's position list), from one to the next. A line
 * that comes back to its first vertex names it again at its end.
 */
export type Chains = readonly (readonly number[])[];

/** What lines along edges say of the shape. */
export type ChainRole = 'crease' | 'smooth' | 'straight';

/** Lines along edges: {@link Chains}. Absent or empty means none. */
export interface ChainsParameter extends Parameter {
  readonly kind: 'chains';
  readonly role: ChainRole;
  /** The parameter that says, in degrees, from which bend on an edge is a crease unasked. */
  readonly angle?: string;
}

export const chains: ValueKind<ChainsParameter, Chains> = {
  problem(_, value) {
    const shape = 'must be [[vertex, vertex, …], …]';
    if (!Array.isArray(value)) return `${shape}, not ${show(value)}.`;
    for (const [index, chain] of value.entries()) {
      if (!Array.isArray(chain)) return `${shape}; line ${index} is ${show(chain)}.`;
      const what = verticesProblem(chain, ` of line ${index}`);
      if (what !== undefined) return what;
      if (chain.length < 2)
        return `must have lines of two vertices or more; line ${index} is ${show(chain)}.`;
    }
    return undefined;
  },
  /** Chain by chain, how many vertices and these. Places that the file stores several times are met once; what is left of one vertex is no line. */
  encode({ name }, all, { vertexOfPosition }): Encoded {
    const count = vertexOfPosition.length;
    const indices: number[] = [];
    for (const [line, chain] of all.entries()) {
      const welded: number[] = [];
      for (const source of chain) {
        const vertex = vertexOfPosition[source];
        if (vertex === undefined) {
          throw new WhittleError(
            'bad-parameter',
            `“${name}” names vertex ${source} in line ${line}, but the file has ${count} vertices (0 to ${count - 1}).`,
            source,
          );
        }
        if (vertex !== welded.at(-1)) welded.push(vertex);
      }
      if (welded.length > 1) indices.push(welded.length, ...welded);
    }
    return { name: '', numbers: noNumbers, indices: Uint32Array.from(indices) };
  },
  help: () => ({ value: 'FILE.json', range: '[[vertex, vertex, …], …], default none' }),
};
