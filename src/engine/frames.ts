import type { Step } from './core-api.ts';
import type { Frame } from './protocol.ts';

/** Progress without positions comes at most this often. */
const progressMilliseconds = 100;

export interface FrameSource {
  /** Whether frames carry positions. */
  readonly withPositions: boolean;
  /** A fresh buffer or, to fill again, one that came back. */
  readonly copyPositions: (into?: Float64Array<ArrayBuffer>) => Float64Array<ArrayBuffer>;
  readonly post: (frame: Frame) => void;
}

/**
 * Hands frames to the page at the page's own pace: the next one leaves only when the last one has been drawn, and carries
 * all iterations since. The solve never waits, and one buffer travels back and forth.
 */
export class FrameGate {
  readonly #source: FrameSource;
  #energy: number[] = [];
  #change: number[] = [];
  #isDrawn = true;
  #lastPost: number;
  #buffer: Float64Array<ArrayBuffer> | undefined;

  constructor(source: FrameSource, now: number) {
    this.#source = source;
    this.#lastPost = now;
  }

  /** Notes an iteration and posts a frame if one is due. */
  add(iteration: number, { energy, change }: Step, now: number): void {
    this.#energy.push(energy);
    this.#change.push(change);
    if (!this.#isDrawn) return;
    const { withPositions, copyPositions, post } = this.#source;
    if (!withPositions && now - this.#lastPost < progressMilliseconds) return;

    const frame = { iteration, energy: this.#energy, change: this.#change };
    post(withPositions ? { ...frame, positions: copyPositions(this.#buffer) } : frame);
    this.#buffer = undefined;
    this.#energy = [];
    this.#change = [];
    this.#isDrawn = false;
    this.#lastPost = now;
  }

  /** The page has drawn the last frame and gives its buffer back, if it still has it. */
  drawn(positions: Float64Array<ArrayBuffer> | undefined): void {
    this.#isDrawn = true;
    this.#buffer = positions;
  }
}
