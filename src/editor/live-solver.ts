import { solverParameters } from '../../web/app/offered-methods.ts';
import { idle, type Store } from '../../web/app/store.ts';
import type { Frame, Solved, SolveSettings } from '../engine/protocol.ts';
import { amend } from './history.ts';
import type { Display } from './presenter.ts';
import { type Result, resultOf, sameShaping, type WhittleDocument } from './project.ts';
import { type Runner, reportFailure, type Task } from './task.ts';

/** Runs the document's method on its mesh, shows what comes and puts the result into the document. */
export class Carver {
  readonly #store: Store;
  readonly #runner: Runner;
  readonly #display: Display;
  #settling: Promise<void> = Promise.resolve();

  constructor(store: Store, runner: Runner, display: Display) {
    this.#store = store;
    this.#runner = runner;
    this.#display = display;
  }

  get #document(): WhittleDocument | null {
    return this.#store.state.document;
  }

  /** The latest {@link carve}; resolves at its end, however it ended. */
  get settling(): Promise<void> {
    return this.#settling;
  }

  /**
   * From the file's own shape to the end, so that the same file and settings always give the same bits.
   *
   * @param watch whether the way there is shown
   */
  carve(watch: boolean): Promise<void> {
    this.#settling = this.#carveNow(watch);
    return this.#settling;
  }

  async #carveNow(watch: boolean): Promise<void> {
    const document = this.#document;
    if (!document) return;
    const task = this.#runner.begin();
    try {
      const solved = await this.#solve(task, document, { start: 'rest', frames: watch }, watch);
      if (!task.current()) return;
      const stopped = solved.outcome === 'cancelled';
      // A settling run that was stopped has shown nothing: what is on the screen is the preview, and that is kept.
      const now = this.#document;
      if (now && stopped && !watch) this.#keepPreview(now);
      else if (now) this.#take(now, resultOf(solved, stopped ? 'stopped' : 'settled'));
      this.#store.set({ activity: idle });
    } catch (thrown) {
      reportFailure(this.#store, task, thrown, () => void this.carve(watch));
    }
  }

  /** One warm run on the way of a gesture. */
  async follow(document: WhittleDocument): Promise<void> {
    const task = this.#runner.begin();
    try {
      const solved = await this.#solve(task, document, { start: 'current', frames: true }, true);
      const now = this.#document;
      // A run that was overtaken by a later value or by the settling run still is the nearest there is to its shape.
      if (now?.mesh !== document.mesh || !sameShaping(now, document)) return;
      if (now.result?.state === 'settled') return;
      const state = solved.outcome === 'cancelled' && task.signal.aborted ? 'stopped' : 'preview';
      this.#amend(now, { ...now, result: resultOf(solved, state) });
      if (task.current()) this.#store.set({ activity: idle });
    } catch (thrown) {
      reportFailure(this.#store, task, thrown, () => void this.carve(false));
    }
  }

  #solve(
    task: Task,
    document: WhittleDocument,
    how: Pick<SolveSettings, 'start' | 'frames'>,
    live: boolean,
  ): Promise<Solved> {
    const { mesh, method } = document;
    const parameters = solverParameters(document);
    const energy: number[] = [];
    this.#store.set({ activity: { kind: 'solving', live, iteration: 0, energy } });
    const onFrame = async (frame: Frame) => {
      energy.push(...frame.energy);
      if (!task.current()) return;
      this.#store.set({ activity: { kind: 'solving', live, iteration: frame.iteration, energy } });
      if (frame.positions) await this.#display.frame(mesh, frame.positions);
    };
    return this.#runner.solve(task, mesh, { method, parameters, ...how }, onFrame);
  }

  #take(document: WhittleDocument, result: Result): void {
    const next = { ...document, result };
    this.#amend(document, next);
    this.#display.document(next);
  }

  #keepPreview(document: WhittleDocument): void {
    if (document.result)
      this.#amend(document, { ...document, result: { ...document.result, state: 'stopped' } });
  }

  #amend(old: WhittleDocument, next: WhittleDocument): void {
    this.#store.set({ document: next, history: amend(this.#store.state.history, old, next) });
    this.#display.adopt(next);
  }
}
