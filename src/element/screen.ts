import type { Canvas } from '../editor/presenter.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { darkTheme, lightTheme, Viewer } from '../viewer/viewer.ts';

/** What is to be seen, whether somebody looks or not. */
interface Scene {
  readonly mesh: Mesh;
  readonly up: 'y' | 'z';
  positions: Float64Array | null;
}

const noInsets = { top: 0, right: 0, bottom: 0, left: 0 } as const;

/**
 * An element's picture. Browsers give a page only a few WebGL contexts, so the element has one while it is on the screen and a still
 * picture while it is not.
 */
export class ElementScreen implements Canvas {
  readonly #host: HTMLElement;
  readonly #onFailure: (thrown: unknown) => void;
  readonly #dark = matchMedia('(prefers-color-scheme: dark)');
  readonly #off = new AbortController();
  readonly #resized: ResizeObserver;
  #viewer: Viewer | null = null;
  #scene: Scene | null = null;
  #label = '';
  #touchAction = 'none';
  #covered = 0;

  /**
   * @param host holds the canvas
   * @param onFailure told when the browser draws no 3D
   */
  constructor(host: HTMLElement, onFailure: (thrown: unknown) => void) {
    this.#host = host;
    this.#onFailure = onFailure;
    this.#dark.addEventListener('change', () => this.#dress(), { signal: this.#off.signal });
    this.#resized = new ResizeObserver(() => this.#fill());
    this.#resized.observe(host);
  }

  get isOpen(): boolean {
    return this.#viewer !== null;
  }

  /** What the picture is of, for those who cannot see it, and which gestures stay the page's. */
  describe(label: string, touchAction: string): void {
    this.#label = label;
    this.#touchAction = touchAction;
    this.#dress();
  }

  /** Keeps the object clear of what covers the lower edge, in CSS pixels. */
  setCovered(bottom: number): void {
    if (bottom === this.#covered) return;
    this.#covered = bottom;
    this.#viewer?.setInsets({ ...noInsets, bottom });
    this.#viewer?.fit(false);
  }

  show(mesh: Mesh, up: 'y' | 'z'): void {
    this.#scene = { mesh, up, positions: null };
    if (this.#viewer) this.#viewer.show(mesh, up);
    else this.open();
  }

  update(positions: Float64Array, glide = 0): void {
    if (this.#scene) this.#scene.positions = positions.slice();
    this.#viewer?.update(positions, glide);
  }

  fit(): void {
    this.#viewer?.fit();
  }

  setShading(shading: 'smooth' | 'flat'): void {
    this.#viewer?.setShading(shading);
  }

  snapshot(background?: string): Promise<Blob> {
    if (!this.#viewer)
      return Promise.reject(new Error('Nothing is drawn while the element is off the screen.'));
    return this.#viewer.snapshot(background);
  }

  /** Takes a context and draws, once there is something to draw. */
  open(): void {
    if (this.#viewer || !this.#scene) return;
    const canvas = document.createElement('canvas');
    canvas.part.add('canvas');
    canvas.tabIndex = 0;
    try {
      this.#viewer = new Viewer(canvas);
    } catch (thrown) {
      this.#onFailure(thrown);
      return;
    }
    this.#host.replaceChildren(canvas);
    this.#dress();
    this.#fill();
    this.#viewer.setInsets({ ...noInsets, bottom: this.#covered });
    const { mesh, up, positions } = this.#scene;
    this.#viewer.show(mesh, up);
    if (positions) this.#viewer.update(positions);
  }

  /** Gives the context back; the last picture stays. */
  close(): void {
    const viewer = this.#viewer;
    if (!viewer) return;
    this.#viewer = null;
    const still = document.createElement('img');
    still.alt = '';
    void viewer.snapshot().then((picture) => {
      still.src = URL.createObjectURL(picture);
      still.addEventListener('load', () => URL.revokeObjectURL(still.src), { once: true });
      if (!this.#viewer) this.#host.replaceChildren(still);
    });
    viewer.dispose();
  }

  dispose(): void {
    this.#off.abort();
    this.#resized.disconnect();
    this.#viewer?.dispose();
    this.#viewer = this.#scene = null;
    this.#host.replaceChildren();
  }

  #dress(): void {
    const { canvas } = this.#viewer ?? {};
    if (!canvas) return;
    canvas.role = 'img';
    canvas.ariaLabel = this.#label;
    canvas.style.touchAction = this.#touchAction;
    this.#viewer!.setTheme(this.#dark.matches ? darkTheme : lightTheme);
  }

  #fill(): void {
    const { width, height } = this.#host.getBoundingClientRect();
    if (width > 0 && height > 0) this.#viewer?.resize(width, height, devicePixelRatio);
  }
}
