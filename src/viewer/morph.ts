/**
 * A short glide of the drawn positions from where they are to a target, for changes that are not themselves an animation
 * (undo, the settled result replacing a preview).
 */
export class Morph {
  readonly #from: Float32Array;
  readonly #to: Float32Array;
  readonly #began: number;
  readonly #duration: number;

  /** @param from, to #P×3; `from` is copied   @param duration milliseconds */
  constructor(from: Float32Array, to: Float32Array, began: number, duration: number) {
    this.#from = from.slice();
    this.#to = to;
    this.#began = began;
    this.#duration = duration;
  }

  /** Writes the positions at a time into `drawn`; false when the target is reached. */
  write(now: number, drawn: Float32Array): boolean {
    const t = Math.min(1, Math.max(0, (now - this.#began) / this.#duration));
    if (t >= 1) {
      drawn.set(this.#to);
      return false;
    }
    const s = t * t * (3 - 2 * t);
    for (let i = 0; i < drawn.length; i++) drawn[i] = this.#from[i]! + s * (this.#to[i]! - this.#from[i]!);
    return true;
  }
}
