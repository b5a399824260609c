import { hasChain, withChain, withoutChain } from '../../src/editor/chains.ts';
import type { Editor } from '../../src/editor/editor.ts';
import { activeStep, type Project } from '../../src/editor/project.ts';
import { withDefaults } from '../../src/editor/steps.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { chainsParameters } from '../../src/methods/set-by-hand.ts';
import type { Chains, ChainsParameter } from '../../src/methods/values/chains.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { PageStore } from './page-state.ts';

/** A line is either of these: what a person calls sharp is not smooth any more. */
const opposites: Readonly<Partial<Record<ChainsParameter['role'], ChainsParameter['role']>>> = {
  crease: 'smooth',
  smooth: 'crease',
};

/** The lines along edges that a person has marked: all that buttons and the tool on the canvas can ask for. */
export class LineActions {
  readonly #store: PageStore;
  readonly #editor: Editor;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
  }

  get project(): Project | null {
    return this.#store.state.project;
  }

  /** What lines can be marked as; nothing where the active step takes none. */
  get parameters(): readonly ChainsParameter[] {
    const { project } = this;
    return project ? chainsParameters(findMethod(activeStep(project).method)) : [];
  }

  /** Degrees from which on an edge of the active step's mesh is a crease unasked; undefined where nothing says. */
  get angle(): number | undefined {
    const { project } = this;
    const named = this.parameters.find(({ angle }) => angle !== undefined)?.angle;
    const step = project && activeStep(project);
    const value = step && named !== undefined ? withDefaults(step).parameters[named] : undefined;
    return typeof value === 'number' ? value : undefined;
  }

  /** Those of one parameter. */
  of({ name }: ChainsParameter): Chains {
    const { project } = this;
    return ((project && activeStep(project).parameters[name]) as Chains | undefined) ?? [];
  }

  /** Whether all of a line (positions of the file) is marked. */
  has(parameter: ChainsParameter, chain: readonly number[]): boolean {
    const { project } = this;
    return project !== null && hasChain(this.of(parameter), project.mesh, chain);
  }

  /** Marks lines, or takes their marks away; one entry for undo. */
  mark(parameter: ChainsParameter, chains: readonly (readonly number[])[], isMarked: boolean): void {
    const { project } = this;
    if (!project) return;
    const { mesh } = project;
    const change = isMarked ? withChain : withoutChain;
    const values = new Map([
      [parameter, chains.reduce((all, one) => change(all, mesh, one), this.of(parameter))],
    ]);
    const other = this.parameters.find(({ role }) => role === opposites[parameter.role]);
    if (other && isMarked)
      values.set(
        other,
        chains.reduce((all, one) => withoutChain(all, mesh, one), this.of(other)),
      );
    this.#commit(values, isMarked ? `Mark ${lower(parameter.label)}` : `Unmark ${lower(parameter.label)}`);
  }

  clear(parameter: ChainsParameter): void {
    this.#commit(new Map([[parameter, []]]), `Unmark ${lower(parameter.label)}`);
  }

  #commit(values: ReadonlyMap<ChainsParameter, Chains>, label: string): void {
    const { project } = this;
    if (!project) return;
    const parameters: Record<string, ParameterValues[string]> = { ...activeStep(project).parameters };
    let isChanged = false;
    for (const [parameter, chains] of values) {
      if (chains === this.of(parameter)) continue;
      isChanged = true;
      if (chains.length > 0) parameters[parameter.name] = chains;
      else delete parameters[parameter.name];
    }
    if (isChanged) this.#editor.commit({ parameters }, label);
  }
}

function lower(label: string): string {
  return label.charAt(0).toLowerCase() + label.slice(1);
}
