import type { Engine } from '../engine/client.ts';
import type { Progress } from '../engine/protocol.ts';
import { type Resolver, runStep, type StepOptions, type StepRun } from '../recipe/index.ts';
import { amend } from './history.ts';
import type { Presenter } from './presenter.ts';
import {
  activeStep,
  findStep,
  firstUnsettled,
  inputsOf,
  meshAt,
  type PlacedStep,
  type Project,
  type Result,
  restShapeOf,
  resultOf,
  sameInputs,
} from './project.ts';
import { type EditorStore, idle } from './state.ts';
import { withStep } from './steps.ts';
import { patiently, reportFailure, type Task, type Tasks } from './task.ts';

export interface LiveSolverParts {
  readonly store: EditorStore;
  readonly engine: Engine;
  readonly resolver: Resolver;
  readonly tasks: Tasks;
  readonly presenter: Presenter;
}

/** Runs the steps of the project, shows what comes and puts the results into it. */
export class LiveSolver {
  readonly #store: EditorStore;
  readonly #engine: Engine;
  readonly #resolver: Resolver;
  readonly #tasks: Tasks;
  readonly #presenter: Presenter;
  #settling: Promise<void> = Promise.resolve();

  constructor({ store, engine, resolver, tasks, presenter }: LiveSolverParts) {
    this.#store = store;
    this.#engine = engine;
    this.#resolver = resolver;
    this.#tasks = tasks;
    this.#presenter = presenter;
  }

  /** The latest {@link settle}; resolves at its end, however it ended. */
  get settling(): Promise<void> {
    return this.#settling;
  }

  /**
   * Runs, each from its rest shape to its end, the steps whose results are missing or of other inputs, so that the same file and
   * recipe always give the same bits. What is settled already is not run again.
   *
   * @param watch whether the way there is shown
   */
  settle(watch: boolean): Promise<void> {
    this.#settling = this.#settleNow(watch);
    return this.#settling;
  }

  async #settleNow(watch: boolean): Promise<void> {
    const task = this.#tasks.begin();
    try {
      for (let next = this.#next(); next && !task.signal.aborted; next = this.#next()) {
        const run = await this.#run(task, next, { start: 'rest', positions: watch, fields: true }, watch);
        if (!task.current()) return;
        this.#finish(next, run, watch);
      }
      if (task.current()) this.#store.set({ activity: idle });
    } catch (thrown) {
      reportFailure(this.#store, task, thrown, () => void this.settle(watch));
    }
  }

  #next(): PlacedStep | undefined {
    const { project } = this.#store.state;
    return project ? firstUnsettled(project) : undefined;
  }

  /** A settling run that was stopped has shown nothing: what is on the screen is the preview, and that is kept. */
  #finish({ step, inputs }: PlacedStep, run: StepRun, watch: boolean): void {
    const isStopped = run.outcome === 'cancelled';
    const { project } = this.#store.state;
    const shown = project && findStep(project, step.id)?.result;
    if (isStopped && !watch && shown) this.#put(step.id, { ...shown, state: 'stopped', of: inputs }, false);
    else this.#put(step.id, resultOf(run, isStopped ? 'stopped' : 'settled', inputs), true);
  }

  /** One warm run of the active step on the way of a gesture. */
  async follow(): Promise<void> {
    const { project } = this.#store.state;
    const step = project && activeStep(project);
    const from = step && restShapeOf(project, step.id);
    if (!step || !from) return;
    const task = this.#tasks.begin();
    const inputs = inputsOf(step, from, project.assets);
    const placed = { step, inputs, isSettled: false };
    try {
      const run = await this.#run(task, placed, { start: 'current', positions: true }, true);
      // A run that was overtaken by a later value or by the settling run still is the nearest there is to its shape.
      if (!this.#isStill(placed)) return;
      const isStopped = run.outcome === 'cancelled' && task.signal.aborted;
      this.#put(step.id, resultOf(run, isStopped ? 'stopped' : 'preview', inputs), task.current());
      if (task.current()) this.#store.set({ activity: idle });
    } catch (thrown) {
      reportFailure(this.#store, task, thrown, () => void this.settle(false));
    }
  }

  /** Whether a step still has these inputs and no better result of them. */
  #isStill({ step: { id }, inputs }: PlacedStep): boolean {
    const { project } = this.#store.state;
    const now = project && findStep(project, id);
    const from = now && restShapeOf(project, id);
    if (!now || !from || !sameInputs(inputsOf(now, from, project.assets), inputs)) return false;
    return now.result?.state !== 'settled' || !sameInputs(now.result.of, inputs);
  }

  async #run(
    task: Task,
    { step, inputs }: PlacedStep,
    how: Pick<StepOptions, 'start' | 'positions' | 'fields'>,
    live: boolean,
  ): Promise<StepRun> {
    const project = this.#store.state.project!;
    const energy: number[] = [];
    const activity = { kind: 'solving', step: step.id, live, energy, preparing: null, iteration: 0 } as const;
    this.#store.set({ activity });
    const onProgress = async (progress: Progress) => {
      if (progress.kind === 'iterating') energy.push(...progress.energy);
      if (!task.current()) return;
      if (progress.kind === 'preparing') {
        this.#store.set({ activity: { ...activity, preparing: progress } });
        return;
      }
      this.#store.set({ activity: { ...activity, iteration: progress.iteration } });
      if (progress.positions) await this.#presenter.follow(project.mesh, progress.positions);
    };
    const { normalMap } = project.source;
    const surface = { mesh: meshAt(project, inputs.from), normalMap };
    const options = { ...how, onProgress, signal: task.signal };
    return patiently(task, () => runStep(this.#engine, this.#resolver, surface, step, options));
  }

  #put(id: number, result: Result, present: boolean): void {
    const project = this.#store.state.project;
    const step = project && findStep(project, id);
    if (!project || !step) return;
    const next = withStep(project, { ...step, result });
    this.#store.set({ project: next, history: amend(this.#store.state.history, project, next) });
    if (present) this.#presenter.present(next);
    else this.#presenter.adopt(next);
    this.#release(project, next);
  }

  /** The worker keeps the mesh of the step that is edited and of the first; others are sent again if they come back. */
  #release(before: Project, now: Project): void {
    const kept = new Set<unknown>([
      now.mesh,
      meshAt(now, restShapeOf(now, now.active) ?? now.mesh.positions),
    ]);
    for (const { result } of before.steps) {
      const mesh = result && meshAt(before, result.of.from);
      if (mesh && !kept.has(mesh)) this.#engine.release(mesh);
    }
  }
}
