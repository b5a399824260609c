import type { KeptProjects } from './kept-projects.ts';
import { type Project, type Step, sameParameters } from './project.ts';
import { saveProject } from './saved-project.ts';
import type { EditorState } from './state.ts';

export interface AutosaveParts {
  readonly store: {
    readonly state: EditorState;
    subscribe(listener: (state: EditorState) => void): () => void;
  };
  readonly projects: KeptProjects;
  /** Under which id this window's work is kept: no other open window has it. */
  readonly id: string;
  /** The link that the work begins with, '' for none. */
  readonly link: string;
  /** Hears once, the first time that something cannot be kept. */
  readonly onTrouble: () => void;
  /** Milliseconds from the last change to the keeping. Default 1000. */
  readonly delay?: number;
}

/**
 * Keeps the project a moment after its last change. The project that the window begins with is nobody's work yet and is not kept:
 * a sample, a link, or what was kept before.
 */
export class Autosave {
  readonly #parts: AutosaveParts;
  /** What the window began with or what was kept last. */
  #kept: Project | null = null;
  /** What left the page as a project file. */
  #saved: Project | null = null;
  /** What was looked at last. */
  #seen: Project | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #writing: Promise<void> = Promise.resolve();
  #isTroubled = false;
  #isHeld = false;

  constructor(parts: AutosaveParts) {
    this.#parts = parts;
    parts.store.subscribe(() => this.#look());
  }

  /** Whether something would be lost if the window were closed now. */
  get isUnsaved(): boolean {
    const { project } = this.#parts.store.state;
    return project !== null && this.#isNew(project) && !(this.#saved && isSameWork(project, this.#saved));
  }

  /** Keeps what there is, at once. */
  flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#writing = this.#writing.then(() => this.#write());
    return this.#writing;
  }

  /** A project that left the page as a file is not lost with the window. */
  noteSaved(project: Project): void {
    this.#saved = project;
  }

  /** Lets go of what was kept, and takes what `begin` opens for a new beginning. */
  async startFresh(begin: () => Promise<void>): Promise<void> {
    this.#isHeld = true;
    clearTimeout(this.#timer);
    try {
      await begin();
      this.#kept = this.#parts.store.state.project;
      this.#writing = this.#writing.then(() => this.#parts.projects.remove(this.#parts.id)).catch(() => {});
      await this.#writing;
    } finally {
      this.#isHeld = false;
    }
    this.#look();
  }

  #look(): void {
    const { project } = this.#parts.store.state;
    if (!project || this.#isHeld) return;
    this.#kept ??= project;
    // Results that arrive change nothing that is kept.
    if (this.#seen && isSameWork(project, this.#seen)) return;
    this.#seen = project;
    clearTimeout(this.#timer);
    if (this.#isNew(project)) this.#timer = setTimeout(() => void this.flush(), this.#parts.delay ?? 1000);
  }

  #isNew(project: Project): boolean {
    return this.#kept !== null && !isSameWork(project, this.#kept);
  }

  async #write(): Promise<void> {
    const { projects, id, link, store, onTrouble } = this.#parts;
    const { project } = store.state;
    if (!project || !this.#isNew(project)) return;
    try {
      await projects.write(id, saveProject(project), link);
      this.#kept = project;
    } catch {
      if (!this.#isTroubled) onTrouble();
      this.#isTroubled = true;
    }
  }
}

/** Whether two projects say the same; their results follow from that. */
function isSameWork(a: Project, b: Project): boolean {
  if (a === b) return true;
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]) as Set<keyof Project>;
  keys.delete('steps');
  return (
    [...keys].every((key) => a[key] === b[key]) &&
    a.steps.length === b.steps.length &&
    a.steps.every((step, k) => isSameStep(step, b.steps[k]!))
  );
}

function isSameStep(a: Step, b: Step): boolean {
  return (
    a.method === b.method &&
    sameParameters(a.parameters, b.parameters) &&
    a.isOn === b.isOn &&
    a.remembered === b.remembered
  );
}
