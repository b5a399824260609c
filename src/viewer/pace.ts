/** Shares of the full resolution, from the best to the quickest. */
const shares = [1, 0.75, 0.5] as const;
/** Longer than this between two drawings of one movement and it stutters, milliseconds. */
const slow = 45;
/** A pause this long is rest, not a slow drawing. */
const rest = 400;

/**
 * How sharp to draw while something moves: a machine that cannot keep up gets fewer pixels until the movement is over, and
 * then one sharp picture. It learns once; a quick machine never notices.
 */
export class Pace {
  #level = 0;
  #late = 0;
  #last = Number.NEGATIVE_INFINITY;

  /** Share of the full resolution for a drawing at this time, one of a movement. */
  moving(now: number): number {
    const gap = now - this.#last;
    this.#last = now;
    if (gap < rest) this.#late = gap > slow ? this.#late + 1 : Math.max(0, this.#late - 1);
    if (this.#late >= 3 && this.#level < shares.length - 1) {
      this.#level++;
      this.#late = 0;
    }
    return shares[this.#level]!;
  }

  /** Whether movements are drawn with fewer pixels, so that rest needs a picture of its own. */
  get isReduced(): boolean {
    return this.#level > 0;
  }
}
