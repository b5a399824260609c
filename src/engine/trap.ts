import { type Failure, toFailure, WhittleError } from '../mesh/failure.ts';

/** The core itself broke (a wasm trap, an abort): whatever it holds can no longer be trusted. */
export class CoreTrap extends Error {
  readonly failure: Failure;

  constructor(failure: Failure) {
    super(failure.message);
    this.failure = failure;
  }
}

/**
 * Calls into the core. What the core refuses passes as the `WhittleError` it is; anything else is a {@link CoreTrap}.
 *
 * @param heapBytes the heap's size, asked only after a trap: near its limit, the trap was a failed allocation
 */
export function inCore<T>(call: () => T, heapBytes: () => number): T {
  try {
    return call();
  } catch (thrown) {
    if (thrown instanceof WhittleError && thrown.code !== 'internal') throw thrown;
    throw new CoreTrap(isMemory(thrown, heapBytes()) ? outOfMemory : toFailure(thrown));
  }
}

const outOfMemory: Failure = {
  code: 'out-of-memory',
  message: 'There is not enough memory for this mesh; try a smaller one.',
};

/** wasm32 ends at 4 GiB; growth goes in large pieces, so that a refused one leaves the heap well below. */
const nearLimit = 2.5 * 2 ** 30;

function isMemory(thrown: unknown, heapBytes: number): boolean {
  const message = thrown instanceof Error ? thrown.message : '';
  return /\bOOM\b|out of memory|enlarge memory|allocation failed/i.test(message) || heapBytes > nearLimit;
}
