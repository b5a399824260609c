import type { Step } from './core-api.ts';
import type { Preparing, Progress } from './protocol.ts';

/** Progress without positions comes at most this often. */
const progressMilliseconds = 100;

export interface ProgressSource {
  /** Whether progress carries positions. */
  readonly withPositions: boolean;
  /** A fresh buffer or, to fill again, one that came back. */
  readonly copyPositions: (into?: Float64Array<ArrayBuffer>) => Float64Array<ArrayBuffer>;
  readonly post: (progress: Progress) => void;
}

/**
 * Hands progress to the page at the page's own pace: the next leaves only when the last has been seen, and carries
 * all iterations since. The solve never waits, and one buffer travels back and forth.
 */
export class ProgressGate {
  readonly #source: ProgressSource;
  #energy: number[] = [];
  #change: number[] = [];
  #isSeen = true;
  #lastPost: number;
  #buffer: Float64Array<ArrayBuffer> | undefined;

  constructor(source: ProgressSource, now: number) {
    this.#source = source;
    this.#lastPost = now;
  }

  /** Posts how far preparing is, if that is due. */
  prepare(progress: Omit<Preparing, 'kind'>, now: number): void {
    if (!this.#isSeen || now - this.#lastPost < progressMilliseconds) return;
    this.#source.post({ kind: 'preparing', ...progress });
    this.#isSeen = false;
    this.#lastPost = now;
  }

  /** Notes an iteration and posts progress if it is due. */
  add(iteration: number, { energy, change }: Step, now: number): void {
    this.#energy.push(energy);
    this.#change.push(change);
    if (!this.#isSeen) return;
    const { withPositions, copyPositions, post } = this.#source;
    if (!withPositions && now - this.#lastPost < progressMilliseconds) return;

    const progress = { kind: 'iterating', iteration, energy: this.#energy, change: this.#change } as const;
    post(withPositions ? { ...progress, positions: copyPositions(this.#buffer) } : progress);
    this.#buffer = undefined;
    this.#energy = [];
    this.#change = [];
    this.#isSeen = false;
    this.#lastPost = now;
  }

  /** The page has seen the latest progress and gives its buffer back, if it still has it. */
  seen(positions: Float64Array<ArrayBuffer> | undefined): void {
    this.#isSeen = true;
    this.#buffer = positions;
  }
}
