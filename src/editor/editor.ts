import type { Engine } from '../engine/client.ts';
import { type Gathering, gatherBeside } from '../engine/gather.ts';
import type { Format } from '../io/index.ts';
import { toFailure } from '../mesh/failure.ts';
import { findMethod } from '../methods/registry.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import {
  checkGroups,
  type Group,
  type Recipe,
  type RecipeStep,
  Resolver,
  type Surroundings,
} from '../recipe/index.ts';
import { type Beginning, beginProject } from './begin-project.ts';
import { amend, record, redo, undo } from './history.ts';
import { LiveSolver } from './live-solver.ts';
import { openFile, type ReadFile } from './open-file.ts';
import type { Presenter } from './presenter.ts';
import {
  type Assets,
  activeInputs,
  activeStep,
  firstUnsettled,
  type Project,
  type Result,
  type StepInputs,
  sameActive,
  sameInputs,
} from './project.ts';
import { recipeOf } from './saved-recipe.ts';
import { startingStep, styleParameter } from './starting-step.ts';
import { type EditorStore, idle, noticeOf } from './state.ts';
import {
  activateStep,
  addStep,
  changeActive,
  moveStep,
  newStep,
  removeStep,
  type StepChange,
  switchStep,
  takeRecipe,
  withResult,
} from './steps.ts';
import { patiently, reportFailure, Tasks } from './task.ts';
import { type Written, writeProject } from './writing.ts';

export interface EditorParts {
  readonly store: EditorStore;
  readonly engine: Engine;
  readonly presenter: Presenter;
  /** Where names lead that the project's own assets do not know. */
  readonly surroundings?: Surroundings;
}

/** What a person does to a mesh: open, shape in a stack of steps, settle, cancel, undo, take home. Knows no page. */
export class Editor {
  readonly store: EditorStore;
  readonly resolver: Resolver;
  /** What has a name here: the project's own assets come first. */
  readonly asset: NonNullable<Surroundings['asset']>;
  readonly #engine: Engine;
  readonly #tasks = new Tasks();
  readonly #presenter: Presenter;
  readonly #solver: LiveSolver;
  /** The project as it was when the gesture that is under way began. */
  #gestureFrom: Project | null = null;
  /** The settings whose run a person stopped: that shape is kept and not settled after all when the gesture ends. */
  #stoppedAt: StepInputs | null = null;
  #latestChoice = 0;

  constructor({ store, engine, presenter, surroundings = {} }: EditorParts) {
    this.asset = (name) => this.project?.assets.get(name) ?? surroundings.asset?.(name);
    this.store = store;
    this.resolver = new Resolver(engine, { ...surroundings, asset: this.asset });
    this.#engine = engine;
    this.#presenter = presenter;
    const { resolver } = this;
    this.#solver = new LiveSolver({ store, engine, resolver, tasks: this.#tasks, presenter });
  }

  get project(): Project | null {
    return this.store.state.project;
  }

  /**
   * Opens a file and runs its stack. The mesh that was there stays until the new one is known to be good.
   *
   * @param readBeside finds files that it refers to, by their paths from its folder
   */
  open(
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    begin: Beginning = {},
    readBeside?: Gathering['read'],
  ): Promise<void> {
    const read = async (signal: AbortSignal) => {
      const gathering = readBeside && { read: readBeside, signal };
      const beside = gathering && (await gatherBeside(this.#engine, bytes, name, gathering));
      const file = { bytes, name, ...(beside ? { beside } : {}) };
      return { ...file, ...(await this.#engine.read(bytes, name, { signal, beside })) };
    };
    return this.#open(name, read, begin);
  }

  /** Opens a file that was read already, and runs its stack. */
  openRead(file: ReadFile, begin: Beginning = {}): Promise<void> {
    return this.#open(file.name, async () => file, begin);
  }

  async #open(
    name: string,
    read: (signal: AbortSignal) => Promise<ReadFile>,
    begin: Beginning,
  ): Promise<void> {
    this.#endGesture();
    this.#tasks.cancel();
    const task = this.#tasks.begin();
    this.store.set({ activity: { kind: 'opening', name }, notice: null });
    try {
      const { project, warnings } = await patiently(task, async () => {
        const file = await read(task.signal);
        this.#solver.hold(file.mesh);
        const opened = await openFile(this.#engine, file, task.signal);
        const begun = await beginProject(opened, begin, this.project, this.resolver);
        task.signal.throwIfAborted();
        return { project: begun, warnings: file.warnings };
      });
      if (task.current()) this.#enter(project, warnings);
    } catch (thrown) {
      reportFailure(this.store, task, thrown, () => void this.#open(name, read, begin));
      // A run was stopped for the file, half way on the screen.
      if (task.current() && this.project) this.#presenter.present(this.project);
    }
    this.#solver.tidy();
    if (task.current() && !task.signal.aborted) await this.#solver.settle(true);
  }

  /** Follows a gesture: shows what these settings of the active step give, from where the shape is now. */
  preview(change: StepChange): void {
    const { project } = this;
    if (!project) return;
    this.#gestureFrom ??= project;
    this.#stoppedAt = null;
    const next = changeActive(project, change);
    this.store.set({ project: next, notice: null });
    this.#presenter.adopt(next);
    void this.#solver.follow();
  }

  /** A gesture is under way: what is shown is on its way to be settled. */
  get isFollowing(): boolean {
    return this.#gestureFrom !== null;
  }

  /**
   * Ends a gesture: notes it for undo and settles it.
   *
   * @param known what these settings give, where that was found out already
   */
  commit(change: StepChange, label: string, known?: Result): void {
    const { project } = this;
    if (!project) return;
    const before = this.#gestureFrom ?? project;
    this.#gestureFrom = null;
    const wanted = withResult(changeActive(project, change), known);
    if (sameActive(before, wanted)) {
      if (before === project) return;
      this.#goTo(before);
      if (firstUnsettled(before)) void this.#solver.settle(true);
      return;
    }
    const keep = this.#stoppedAt !== null && sameInputs(this.#stoppedAt, activeInputs(wanted));
    this.#stoppedAt = null;
    const after = keep ? project : wanted;
    this.store.set({
      project: after,
      history: record(this.store.state.history, { label, before, after }),
      notice: null,
    });
    if (keep) return;
    this.#presenter.adopt(after);
    void this.#solver.settle(false);
  }

  /** Solves the active step anew with other settings and shows how; one entry for undo. */
  restyle(change: StepChange, label: string): void {
    this.#change((project) => changeActive(project, change), label);
  }

  /**
   * Gives the active step another method: with the values that it had here before, or with those that suit the mesh.
   *
   * @param given values that are to be these
   * @param label what undo calls it; default the method's title
   */
  async chooseMethod(id: string, given: ParameterValues = {}, label = findMethod(id)?.title): Promise<void> {
    this.#latestChoice++;
    const step = this.project && activeStep(this.project);
    if (!step || label === undefined || step.method === id) return;
    const remembered = step.remembered[id];
    if (remembered) return this.restyle({ method: id, parameters: { ...remembered, ...given } }, label);
    await this.#afterReading({ method: id, given }, (starting) => this.restyle(starting, label));
  }

  /** Puts a step with this method after the active one. @param given values that are to be these */
  async addStep(id: string, given: ParameterValues = {}): Promise<void> {
    const title = findMethod(id)?.title;
    if (!title) return;
    await this.#afterReading({ method: id, given }, (starting) =>
      this.#change((project) => addStep(project, newStep(starting)), `Add ${title}`),
    );
  }

  /** Puts the steps of a recipe in the place of those that there are; one entry for undo. @param assets what they name */
  takeRecipe(recipe: Recipe, assets: Assets, label: string): void {
    this.#change((project) => takeRecipe(project, recipe, assets), label);
  }

  removeStep(id: number): void {
    this.#change((project) => removeStep(project, id), 'Remove a step');
  }

  /** @param to place in the stack, from 0 */
  moveStep(id: number, to: number): void {
    this.#change((project) => moveStep(project, id, to), 'Move a step');
  }

  switchStep(id: number, isOn: boolean): void {
    const label = isOn ? 'Switch a step on' : 'Switch a step off';
    this.#change((project) => switchStep(project, id, isOn), label);
  }

  /** Names vertices, or takes names away: see `groups.ts`. @throws WhittleError if a group names vertices that the mesh has not */
  changeGroups(changed: (groups: readonly Group[]) => readonly Group[], label: string): void {
    this.#change((project) => {
      const groups = changed(project.groups);
      checkGroups(groups, project.mesh.positions.length / 3);
      return groups === project.groups ? project : { ...project, groups };
    }, label);
  }

  /** Makes a step the one that is edited. No entry for undo: nothing of the shape changes. */
  activate(id: number): void {
    this.#endGesture();
    const { project } = this;
    const next = project && activateStep(project, id);
    if (!next || next === project) return;
    this.#latestChoice++;
    this.store.set({ project: next, history: amend(this.store.state.history, project, next) });
    this.#presenter.adopt(next);
    this.#solver.tidy();
  }

  /** Brings the active step back to the values that suit the mesh. */
  async reset(): Promise<void> {
    const step = this.project && activeStep(this.project);
    if (!step) return;
    const parameter = styleParameter(findMethod(step.method));
    const style = parameter ? step.parameters[parameter.name] : undefined;
    const given: ParameterValues = parameter && style !== undefined ? { [parameter.name]: style } : {};
    await this.#afterReading({ method: step.method, given }, ({ parameters }) =>
      this.commit({ parameters }, 'Reset'),
    );
  }

  /** Stops what is running; the shape on the screen stays. */
  cancel(): boolean {
    if (this.store.state.activity.kind === 'idle') return false;
    if (this.#gestureFrom && this.project) this.#stoppedAt = activeInputs(this.project);
    this.#tasks.cancel();
    return true;
  }

  /** Takes back the gesture that is under way or else the latest that has ended. False if there was none. */
  undo(): boolean {
    return this.dropGesture() || this.#travel(undo(this.store.state.history), 'before');
  }

  /** Takes back the gesture that is under way. False if there is none: nothing of it was previewed yet. */
  dropGesture(): boolean {
    const from = this.#gestureFrom;
    if (!from) return false;
    this.#gestureFrom = null;
    this.#goTo(from);
    return true;
  }

  redo(): boolean {
    return this.#travel(redo(this.store.state.history), 'after');
  }

  /** Stops everything and gives the worker its meshes back; the editor is not used any more. */
  dispose(): void {
    this.#latestChoice++;
    this.#tasks.abandon();
    this.#solver.dispose();
  }

  /** The steps that are on, as a recipe. */
  recipe(): Recipe | null {
    return this.project && recipeOf(this.project);
  }

  /** The file in a format with the settled shape. Null if it could not be written; a notice says why. */
  async write(format: Format): Promise<Written | null> {
    this.#endGesture();
    await this.#solver.settling;
    if (this.project && firstUnsettled(this.project)) await this.#solver.settle(false);
    const parts = { store: this.store, engine: this.#engine, tasks: this.#tasks };
    return this.project && writeProject(parts, this.project, format, () => void this.write(format));
  }

  #enter(project: Project, warnings: readonly string[]): void {
    const before = this.#gestureFrom ?? this.project;
    this.#gestureFrom = null;
    const label = `Open ${project.source.name}`;
    const { history } = this.store.state;
    this.store.set({
      project,
      history: before ? record(history, { label, before, after: project }) : history,
      ...noticeOf(warnings),
    });
    this.#latestChoice++;
    this.#presenter.present(project);
  }

  /** Reads what a step borrows and goes on with it, unless something else was chosen meanwhile. */
  async #afterReading(
    { method: id, given }: { method: string; given: ParameterValues },
    go: (starting: RecipeStep) => void,
  ): Promise<void> {
    const turn = ++this.#latestChoice;
    const { project } = this;
    const method = findMethod(id);
    if (!project || !method) return;
    try {
      const starting = await startingStep(method, given, project, this.resolver);
      if (turn === this.#latestChoice && this.project?.mesh === project.mesh) go(starting);
    } catch (thrown) {
      if (turn !== this.#latestChoice) return;
      this.store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
    }
  }

  /** Makes of a gesture that is under way one entry: something else begins. */
  #endGesture(): void {
    if (this.#gestureFrom) this.commit({}, findMethod(activeStep(this.project!).method)?.title ?? 'Change');
  }

  /** One finished change of the stack; what it made stale is solved, and shown as it comes. */
  #change(changed: (project: Project) => Project, label: string): void {
    this.#endGesture();
    const before = this.project;
    const after = before && changed(before);
    if (!after || after === before) return;
    this.#latestChoice++;
    this.#stoppedAt = null;
    this.store.set({
      project: after,
      history: record(this.store.state.history, { label, before, after }),
      notice: null,
    });
    this.#presenter.present(after);
    void this.#solver.settle(true);
  }

  #travel(step: ReturnType<typeof undo>, to: 'before' | 'after'): boolean {
    if (!step) return false;
    this.#gestureFrom = null;
    this.store.set({ history: step.history });
    this.#goTo(step.entry[to]);
    return true;
  }

  #goTo(project: Project): void {
    this.#tasks.abandon();
    this.#latestChoice++;
    this.store.set({ project, activity: idle, notice: null });
    this.#presenter.present(project);
    this.#solver.tidy();
  }
}
