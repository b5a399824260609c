import { onSphere } from '../../src/inputs/styles/captures.ts';
import { Portraits, type Subject } from '../../src/viewer/portraits.ts';
import { darkTheme, lightTheme } from '../../src/viewer/stage.ts';
import type { StyleEntry } from './style-gallery.ts';

/** Milliseconds of every frame that pictures may take. */
const budget = 7;

/** Fills the gallery's pictures, a few per frame, with one renderer that is let go at the end. */
export class Thumbnails {
  readonly #drawn = new WeakMap<HTMLCanvasElement, string>();
  #queue: { canvas: HTMLCanvasElement; entry: StyleEntry }[] = [];
  #portraits: Portraits | null = null;
  #theme = '';
  #frame = 0;

  /** Draws what has no picture yet in the page's present colours. Each canvas names its entry in `data-picture`. */
  look(canvases: Iterable<HTMLCanvasElement>, find: (id: string) => StyleEntry | undefined): void {
    const theme = document.documentElement.dataset.theme ?? 'light';
    if (theme !== this.#theme) this.#release();
    this.#theme = theme;
    this.#queue = [];
    for (const canvas of canvases) {
      const entry = find(canvas.dataset.picture!);
      if (entry && this.#drawn.get(canvas) !== `${theme} ${entry.id}`) this.#queue.push({ canvas, entry });
    }
    if (this.#queue.length > 0 && this.#frame === 0) this.#next();
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#queue = [];
    this.#release();
  }

  #next(): void {
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      const until = performance.now() + budget;
      do this.#take();
      while (this.#queue.length > 0 && performance.now() < until);
      if (this.#queue.length > 0) this.#next();
      else this.#release();
    });
  }

  #take(): void {
    const next = this.#queue.shift();
    if (!next) return;
    try {
      this.#portraits ??= new Portraits(128, this.#theme === 'dark' ? darkTheme : lightTheme);
      this.#portraits.draw(subjectOf(next.entry), next.canvas);
      this.#drawn.set(next.canvas, `${this.#theme} ${next.entry.id}`);
    } catch {
      // Without WebGL the names have to do.
      this.#queue = [];
    }
  }

  #release(): void {
    this.#portraits?.dispose();
    this.#portraits = null;
  }
}

/** A capture is a ball that is lit as if it had the captured normals. */
export function subjectOf(entry: StyleEntry): Subject {
  const subject = entry.subject();
  if ('mesh' in subject) return subject;
  const { points, triangles, normals } = onSphere(subject.map);
  return { mesh: { positions: points as never, triangles: triangles as never }, normals };
}
