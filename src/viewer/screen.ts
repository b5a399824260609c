import { Pace } from './pace.ts';
import type { Renderer } from './renderer.ts';

/** The renderer's pixels: as many as the canvas has, fewer for a movement that a slow machine cannot draw in time. */
export class Screen {
  readonly #renderer: Renderer;
  readonly #pace = new Pace();
  #size = { width: 1, height: 1, pixelRatio: 1 };
  #share = 1;
  #resting: ReturnType<typeof setTimeout> | undefined;

  constructor(renderer: Renderer) {
    this.#renderer = renderer;
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#size = { width, height, pixelRatio };
    this.#apply(this.#share);
  }

  /** To be called before each drawing. @param draw makes the sharp picture once the movement is over */
  move(now: number, draw: () => void): void {
    const share = this.#pace.moving(now);
    if (share !== this.#share) this.#apply(share);
    if (!this.#pace.isReduced) return;
    clearTimeout(this.#resting);
    this.#resting = setTimeout(() => {
      this.sharpen();
      draw();
    }, 250);
  }

  /** All the pixels there are. */
  sharpen(): void {
    if (this.#share !== 1) this.#apply(1);
  }

  dispose(): void {
    clearTimeout(this.#resting);
  }

  #apply(share: number): void {
    this.#share = share;
    const { width, height, pixelRatio } = this.#size;
    this.#renderer.setPixelRatio(pixelRatio * share);
    this.#renderer.setSize(width, height, false);
  }
}
