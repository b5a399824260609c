/** Draws when something changed and only then: an idle page asks for no animation frames. */
export class RenderLoop {
  readonly #draw: (now: number) => void;
  readonly #request: (callback: (now: number) => void) => number;
  readonly #cancel: (handle: number) => void;
  #pending: number | null = null;
  #paused = false;

  constructor(
    draw: (now: number) => void,
    request: (callback: (now: number) => void) => number = (callback) => requestAnimationFrame(callback),
    cancel: (handle: number) => void = (handle) => cancelAnimationFrame(handle),
  ) {
    this.#draw = draw;
    this.#request = request;
    this.#cancel = cancel;
  }

  /** Asks for one drawing; calls before it happens cost nothing more. */
  readonly invalidate = (): void => {
    if (this.#pending !== null || this.#paused) return;
    this.#pending = this.#request((now) => {
      this.#pending = null;
      this.#draw(now);
    });
  };

  /** Stops drawing (a lost context); {@link resume} draws again. */
  pause(): void {
    this.#paused = true;
    if (this.#pending !== null) this.#cancel(this.#pending);
    this.#pending = null;
  }

  resume(): void {
    this.#paused = false;
    this.invalidate();
  }
}
