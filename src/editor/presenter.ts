import { formatInfo } from '../io/index.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { shownPositions, type WhittleDocument } from './project.ts';

/** What a document needs of a viewer. */
export interface Canvas {
  show(mesh: Mesh, up: 'y' | 'z'): void;
  update(positions: Float64Array, glide?: number): void;
}

/** Shows the right thing at the right time: the document, a running solve's frames, or the file's own shape to compare. */
export class Display {
  readonly #canvas: Canvas | null;
  readonly #glide: () => number;
  readonly #drawn: () => Promise<void>;
  #document: WhittleDocument | null = null;
  #mesh: Mesh | null = null;
  #comparing = false;

  /**
   * @param canvas null where nothing can be drawn; everything else still works
   * @param glide milliseconds for changes that jump; 0 for people who want less motion
   * @param drawn resolves when what was last updated is on the screen
   */
  constructor(canvas: Canvas | null, glide: () => number, drawn: () => Promise<void>) {
    this.#canvas = canvas;
    this.#glide = glide;
    this.#drawn = drawn;
  }

  get comparing(): boolean {
    return this.#comparing;
  }

  document(document: WhittleDocument): void {
    const fresh = this.#mesh !== document.mesh;
    this.#document = document;
    this.#mesh = document.mesh;
    if (fresh) this.#canvas?.show(document.mesh, formatInfo(document.source.format).up);
    if (!this.#comparing && (!fresh || document.result))
      this.#canvas?.update(shownPositions(document), fresh ? 0 : this.#glide());
  }

  /** Takes over a document that looks like what is on the screen already. */
  adopt(document: WhittleDocument): void {
    this.#document = document;
  }

  /** Draws a frame of a running solve; resolves when it has been seen. */
  frame(mesh: Mesh, positions: Float64Array): Promise<void> {
    if (mesh === this.#mesh && !this.#comparing) this.#canvas?.update(positions);
    return this.#drawn();
  }

  compare(on: boolean): void {
    if (on === this.#comparing || !this.#document) return;
    this.#comparing = on;
    const { mesh } = this.#document;
    this.#canvas?.update(on ? mesh.positions : shownPositions(this.#document), this.#glide() / 2);
  }
}
