/** Work in pieces: each `yield` is a place where it may pause. A piece of half a million faces takes tens of milliseconds at most. */
export type Work<Value> = Generator<void, Value, undefined>;

/** How many small things a loop does between two places where it may pause. */
export const pieceLength = 2 ** 17;

/** Does all of it now. */
export function atOnce<Value>(work: Work<Value>): Value {
  for (;;) {
    const piece = work.next();
    if (piece.done) return piece.value;
  }
}

export interface SliceOptions {
  /** Milliseconds after which others get a turn, default 8. A piece that takes longer is not cut. */
  readonly budget?: number;
  /** Lets others have their turn. Default: a task of the event loop. */
  readonly pause?: () => Promise<void>;
  /** Work that nobody waits for any more ends at its next pause: the promise rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

/** Does it beside other work of the same thread. */
export async function inSlices<Value>(work: Work<Value>, options: SliceOptions = {}): Promise<Value> {
  const { budget = 8, pause = nextTask, signal } = options;
  for (let began = performance.now(); ; ) {
    const piece = work.next();
    if (piece.done) return piece.value;
    if (performance.now() - began < budget) continue;
    await pause();
    signal?.throwIfAborted();
    began = performance.now();
  }
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
}
