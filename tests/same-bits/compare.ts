import { readMesh } from '../../src/io/index.ts';
import type { Result, Step } from './trees.ts';

/** What sets two results of one command line apart, for the table; nothing where they are the same. */
export interface Difference {
  readonly file?: string;
  readonly energy?: string;
}

/** Holds the files against each other byte by byte and the energies of all iterations bit by bit. */
export function compare(base: Result, head: Result): Difference {
  const file = Buffer.compare(base.file, head.file) === 0 ? undefined : describeFiles(base.file, head.file);
  const energy = describeSteps(base.steps, head.steps);
  return { ...(file ? { file } : {}), ...(energy ? { energy } : {}) };
}

function describeFiles(base: Uint8Array, head: Uint8Array): string {
  const shared = Math.min(base.length, head.length);
  let first = 0;
  while (first < shared && base[first] === head[first]) first++;
  const where = `differs from byte ${first} on`;
  const [was, is] = [positionsOf(base), positionsOf(head)];
  if (was?.length !== is?.length || !was || !is) return where;
  const farthest = was.reduce((most, x, i) => Math.max(most, Math.abs(x - is[i]!)), 0);
  return `${where}, positions by ${farthest.toExponential(1)}`;
}

function positionsOf(file: Uint8Array): Float64Array | undefined {
  try {
    return readMesh(file, 'a result').mesh.positions;
  } catch {
    return undefined;
  }
}

function describeSteps(base: readonly Step[], head: readonly Step[]): string | undefined {
  const shown = (steps: readonly Step[]): string =>
    steps.map(({ method, iterations, outcome }) => `${method} ${outcome} after ${iterations}`).join(', ');
  if (shown(base) !== shown(head)) return `${shown(base)} → ${shown(head)}`;
  for (const [s, step] of base.entries()) {
    const k = step.energy.findIndex((value, index) => value !== head[s]!.energy[index]);
    if (k >= 0) return `differs from iteration ${k + 1} of step ${s + 1} on`;
  }
  return undefined;
}
