import { formatInfo } from '../io/index.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { type Project, shownPositions } from './project.ts';

/** What a project needs of a viewer. */
export interface Canvas {
  show(mesh: Mesh, up: 'y' | 'z'): void;
  update(positions: Float64Array, glide?: number): void;
}

export interface PresenterOptions {
  /** Milliseconds for changes that jump; 0 for people who want less motion. Default 0. */
  readonly glide?: () => number;
  /** Resolves when what was last updated is on the screen. Default: at once. */
  readonly drawn?: () => Promise<void>;
}

/** Shows the right thing at the right time: the project, a running solve's frames, or the file's own shape to compare. */
export class Presenter {
  readonly #canvas: Canvas | null;
  readonly #glide: () => number;
  readonly #drawn: () => Promise<void>;
  #project: Project | null = null;
  #mesh: Mesh | null = null;
  #comparing = false;

  /** @param canvas null where nothing can be drawn; everything else still works */
  constructor(canvas: Canvas | null, { glide = () => 0, drawn = async () => {} }: PresenterOptions = {}) {
    this.#canvas = canvas;
    this.#glide = glide;
    this.#drawn = drawn;
  }

  get comparing(): boolean {
    return this.#comparing;
  }

  /** Shows a project. */
  present(project: Project): void {
    const isFresh = this.#mesh !== project.mesh;
    const positions = shownPositions(project);
    this.#project = project;
    this.#mesh = project.mesh;
    if (isFresh) this.#canvas?.show(project.mesh, formatInfo(project.source.format).up);
    const isMoved = !isFresh || positions !== project.mesh.positions;
    if (!this.#comparing && isMoved) this.#canvas?.update(positions, isFresh ? 0 : this.#glide());
  }

  /** Takes over a project that looks like what is on the screen already. */
  adopt(project: Project): void {
    this.#project = project;
  }

  /** Draws a frame of a running solve (#P×3); resolves when it has been seen. */
  frame(mesh: Mesh, positions: Float64Array): Promise<void> {
    if (mesh === this.#mesh && !this.#comparing) this.#canvas?.update(positions);
    return this.#drawn();
  }

  compare(on: boolean): void {
    if (on === this.#comparing || !this.#project) return;
    this.#comparing = on;
    const { mesh } = this.#project;
    this.#canvas?.update(on ? mesh.positions : shownPositions(this.#project), this.#glide() / 2);
  }
}
