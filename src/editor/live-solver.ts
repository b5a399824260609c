import type { Engine } from '../engine/client.ts';
import type { Progress } from '../engine/protocol.ts';
import type { Mesh } from '../mesh/mesh.ts';
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
  placedSteps,
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

/** A run that has not ended yet. */
interface Run {
  readonly mesh: Mesh;
  readonly overtaken: AbortController;
}

/** Runs the steps of the project, shows what comes and puts the results into it. */
export class LiveSolver {
  readonly #store: EditorStore;
  readonly #engine: Engine;
  readonly #resolver: Resolver;
  readonly #tasks: Tasks;
  readonly #presenter: Presenter;
  /** The meshes that the worker was given. */
  readonly #held = new Set<Mesh>();
  readonly #runs = new Set<Run>();
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

  /** Notes that the worker is given a mesh. */
  hold(mesh: Mesh): void {
    this.#held.add(mesh);
  }

  /**
   * Lets the worker forget the meshes that are not likely to be asked for next, those that are neither the file's nor of the step
   * that is edited nor of one that runs: they are sent again if they come back.
   */
  tidy(): void {
    const { project, activity } = this.#store.state;
    if (activity.kind === 'opening') return;
    const kept = new Set([...this.#runs].map(({ mesh }) => mesh));
    if (project) {
      const edited = restShapeOf(project, project.active) ?? project.mesh.positions;
      kept.add(project.mesh).add(meshAt(project, edited));
    }
    for (const mesh of this.#held) if (!kept.has(mesh)) this.#release(mesh);
  }

  /** Gives everything back. */
  dispose(): void {
    this.#stopOthers(null);
    for (const mesh of this.#held) this.#release(mesh);
  }

  async #settleNow(watch: boolean): Promise<void> {
    const task = this.#tasks.begin();
    try {
      // Where every result is known nothing runs, and nothing else would show it.
      if (!this.#next()) this.#show();
      for (let next = this.#next(); next && !task.signal.aborted; next = this.#next()) {
        const run = await this.#run(task, next, { start: 'rest', positions: watch, fields: true }, watch);
        if (!task.current()) return;
        this.#finish(next, run, watch);
      }
      if (!task.current()) return;
      this.#stopOthers(null);
      this.#store.set({ activity: idle });
      this.tidy();
    } catch (thrown) {
      this.#fail(task, thrown, watch);
    }
  }

  #next(): PlacedStep | undefined {
    const { project } = this.#store.state;
    return project ? firstUnsettled(project) : undefined;
  }

  /** A settling run that was stopped may have shown nothing: then a preview that is on the screen is kept. */
  #finish({ step, inputs }: PlacedStep, run: StepRun, watch: boolean): void {
    const isStopped = run.outcome === 'cancelled';
    const { project } = this.#store.state;
    const shown = project && findStep(project, step.id)?.result;
    if (isStopped && !watch && shown?.of.from === inputs.from)
      this.#put(step.id, { ...shown, state: 'stopped', of: inputs }, true);
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
      // What was abandoned is of a shape that is not there any more.
      if (task.signal.aborted && !task.current()) return;
      // A run that was overtaken by a later value or by the settling run still is the nearest there is to its shape.
      const state = run.outcome === 'cancelled' && task.signal.aborted ? 'stopped' : 'preview';
      // While a newer run draws, the screen is that one's.
      const isOnTop = task.current() || this.#runs.size === 0;
      if (this.#isWanting(placed)) this.#put(step.id, resultOf(run, state, inputs), isOnTop);
      else if (isOnTop) this.#show();
      if (task.current()) this.#store.set({ activity: idle });
    } catch (thrown) {
      this.#fail(task, thrown, false);
    }
  }

  /** Whether a step still has these inputs, and no result of them that counts for more than a preview. */
  #isWanting({ step: { id }, inputs }: PlacedStep): boolean {
    const { project } = this.#store.state;
    const placed = project && placedSteps(project).find(({ step }) => step.id === id);
    return !!placed && !placed.isSettled && sameInputs(placed.inputs, inputs);
  }

  #fail(task: Task, thrown: unknown, watch: boolean): void {
    reportFailure(this.#store, task, thrown, () => void this.settle(watch));
    if (task.current()) this.#show();
  }

  /** Brings the screen, which a run may have taken half way, to what the project has. */
  #show(): void {
    const { project } = this.#store.state;
    if (project) this.#presenter.present(project);
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
    const mesh = meshAt(project, inputs.from);
    const run: Run = { mesh, overtaken: new AbortController() };
    this.#stopOthers(mesh);
    this.#runs.add(run);
    this.hold(mesh);
    const { normalMap } = project.source;
    const signal = AbortSignal.any([task.signal, run.overtaken.signal]);
    // A newer run may have been faster to read what it names; for the engine the latest request is the newest.
    const onResolved = () => {
      if (!task.current()) throw new DOMException('A newer run came first.', 'AbortError');
    };
    const options = { ...how, onProgress, onResolved, signal };
    try {
      return await patiently(task, () =>
        runStep(this.#engine, this.#resolver, { mesh, normalMap }, step, options),
      );
    } finally {
      this.#runs.delete(run);
      this.tidy();
    }
  }

  /** Ends runs that a newer one has overtaken. The engine does that for those of the same mesh, when they have shown something. */
  #stopOthers(mesh: Mesh | null): void {
    for (const run of this.#runs) if (run.mesh !== mesh) run.overtaken.abort();
  }

  #release(mesh: Mesh): void {
    this.#held.delete(mesh);
    this.#engine.release(mesh);
  }

  #put(id: number, result: Result, present: boolean): void {
    const project = this.#store.state.project;
    const step = project && findStep(project, id);
    if (!project || !step) return;
    const next = withStep(project, { ...step, result });
    this.#store.set({ project: next, history: amend(this.#store.state.history, project, next) });
    if (present) this.#presenter.present(next);
    else this.#presenter.adopt(next);
  }
}
