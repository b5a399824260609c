import type { Project } from '../../src/editor/project.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { inSlices, type SelectableMesh, selectableOf } from '../../src/selection/index.ts';

/** The project's mesh as a person takes hold of it: made beside other work when it is first asked for, and once a file and angle. */
export class Selectable {
  #mesh: Mesh | null = null;
  #angle: number | undefined;
  #surface: SelectableMesh | null = null;
  #making: Promise<SelectableMesh> | null = null;
  #off = new AbortController();
  readonly #changed: () => void;

  /** @param changed there is a surface now that was not there before */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /**
   * As soon as there is one; null meanwhile, and its making begins.
   *
   * @param angle degrees from which on an edge is a feature, as of {@link selectableOf}
   */
  of(project: Project, angle?: number): SelectableMesh | null {
    void this.ready(project, angle).catch(() => {});
    return this.#mesh === project.mesh ? this.#surface : null;
  }

  ready(project: Project, angle?: number): Promise<SelectableMesh> {
    if (this.#mesh === project.mesh && this.#angle === angle && this.#making) return this.#making;
    this.#off.abort();
    this.#off = new AbortController();
    this.#mesh = project.mesh;
    this.#angle = angle;
    this.#surface = null;
    const { signal } = this.#off;
    this.#making = inSlices(selectableOf(project.mesh, { angle }), { signal });
    this.#making.then(
      (surface) => {
        if (signal.aborted) return;
        this.#surface = surface;
        this.#changed();
      },
      () => {},
    );
    return this.#making;
  }
}
