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
  /** Somebody may be looking: the element is near the part of the page that is on the screen. */
  #isSeen = false;
  #shading: 'smooth' | 'flat' = 'smooth';
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

  /** What the picture is of, for those who cannot see it, or nothing for mere decoration; and which gestures stay the page's. */
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
    else if (this.#isSeen) this.open();
  }

  update(positions: Float64Array, glide = 0): void {
    if (this.#scene) this.#scene.positions = positions.slice();
    this.#viewer?.update(positions, glide);
  }

  fit(): void {
    this.#viewer?.fit();
  }

  setShading(shading: 'smooth' | 'flat'): void {
    this.#shading = shading;
    this.#viewer?.setShading(shading);
  }

  snapshot(background?: string): Promise<Blob> {
    if (!this.#viewer)
      return Promise.reject(new Error('Nothing is drawn while the element is off the screen.'));
    return this.#viewer.snapshot(background);
  }

  /** Takes a context and draws, once there is something to draw. */
  open(): void {
    this.#isSeen = true;
    if (this.#viewer || !this.#scene) return;
    const canvas = document.createElement('canvas');
    canvas.part.add('canvas');
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
    this.#viewer.setShading(this.#shading);
    const { mesh, up, positions } = this.#scene;
    this.#viewer.show(mesh, up);
    if (positions) this.#viewer.update(positions);
  }

  /** Gives the context back; the last picture stays. */
  close(): void {
    const viewer = this.#viewer;
    this.#isSeen = false;
    this.#viewer = null;
    if (!viewer) return;
    // A picture that cannot be made leaves the last frame of the canvas, or nothing.
    void this.#leave(viewer.snapshot()).catch(() => {});
    viewer.dispose();
  }

  async #leave(snapshot: Promise<Blob>): Promise<void> {
    const still = document.createElement('img');
    still.alt = '';
    still.src = URL.createObjectURL(await snapshot);
    still.addEventListener('load', () => URL.revokeObjectURL(still.src), { once: true });
    if (!this.#viewer && this.#scene) this.#host.replaceChildren(still);
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
    const isNamed = this.#label !== '';
    // What is only decoration is not to be stopped at.
    canvas.role = isNamed ? 'img' : 'presentation';
    canvas.ariaLabel = isNamed ? this.#label : null;
    if (isNamed) canvas.tabIndex = 0;
    else canvas.removeAttribute('tabindex');
    canvas.style.touchAction = this.#touchAction;
    this.#viewer!.setTheme(this.#dark.matches ? darkTheme : lightTheme);
  }

  #fill(): void {
    const { width, height } = this.#host.getBoundingClientRect();
    if (width > 0 && height > 0) this.#viewer?.resize(width, height, devicePixelRatio);
  }
}
