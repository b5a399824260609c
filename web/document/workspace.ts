import type { Frame, Solved, SolveSettings } from '../../src/engine/protocol.ts';
import { toFailure } from '../../src/mesh/failure.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { Display } from './display.ts';
import {
  type Result,
  resultOf,
  type Shaping,
  sameShaping,
  type WhittleDocument,
  withShaping,
} from './document.ts';
import { amend, record, redo, undo } from './history.ts';
import { offeredMethods, solverParameters, startingParameters, takesStyle } from './offered-methods.ts';
import { isWorkerLost, type Runner, type Task } from './runner.ts';
import type { Store } from './store.ts';

const idle = Object.freeze({ kind: 'idle' as const });

/** What a person does to the document: open, shape, settle, cancel, undo, take home. */
export class Workspace {
  readonly store: Store;
  readonly #runner: Runner;
  readonly #display: Display;
  /** The document as it was when the gesture that is under way began. */
  #gestureFrom: WhittleDocument | null = null;
  #settling: Promise<void> = Promise.resolve();
  /** The settings whose run a person stopped: that shape is kept and not settled after all when the gesture ends. */
  #stoppedAt: Shaping | null = null;

  constructor(store: Store, runner: Runner, display: Display) {
    this.store = store;
    this.#runner = runner;
    this.#display = display;
  }

  get document(): WhittleDocument | null {
    return this.store.state.document;
  }

  /** Opens a file and carves it. The mesh that was there stays until the new one is known to be good. */
  async open(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<void> {
    this.#runner.cancel();
    const task = this.#runner.begin();
    this.#gestureFrom = null;
    this.store.set({ activity: { kind: 'opening', name }, notice: null });
    try {
      const document = await this.#runner.patiently(task, () => this.#understand(task, bytes, name));
      if (task.current()) this.#enter(document, `Open ${name}`);
    } catch (thrown) {
      this.#fail(task, thrown, () => void this.open(bytes, name));
      return;
    }
    await this.#carve(true);
  }

  /** Follows a gesture: shows what these settings give, from where the shape is now. */
  preview(change: Partial<Shaping>): void {
    const document = this.document;
    if (!document) return;
    this.#gestureFrom ??= document;
    this.#stoppedAt = null;
    const next = withShaping(document, change);
    this.store.set({ document: next, notice: null });
    this.#display.adopt(next);
    void this.#follow(next);
  }

  /** Ends a gesture: notes it for undo and settles it. */
  commit(change: Partial<Shaping>, label: string): void {
    const document = this.document;
    if (!document) return;
    const before = this.#gestureFrom ?? document;
    this.#gestureFrom = null;
    const wanted: Shaping = { ...document, ...change };
    if (sameShaping(before, wanted)) {
      if (before !== document) this.#goTo(before);
      return;
    }
    const keep = this.#stoppedAt !== null && sameShaping(this.#stoppedAt, wanted);
    this.#stoppedAt = null;
    const after = keep ? document : withShaping(document, change);
    this.store.set({
      document: after,
      history: record(this.store.state.history, { label, before, after }),
      notice: null,
    });
    if (keep) return;
    this.#display.adopt(after);
    void this.#carve(false);
  }

  chooseMethod(id: string): void {
    const document = this.document;
    const method = findMethod(id);
    if (!document || !method || document.method === id) return;
    this.restyle({ method: id, parameters: startingParameters(method, document) }, method.title);
  }

  /** Carves anew with other settings and shows how; one entry for undo. */
  restyle(change: Partial<Shaping>, label: string): void {
    const before = this.document;
    if (!before) return;
    this.#gestureFrom = this.#stoppedAt = null;
    const after = withShaping(before, change);
    const history = record(this.store.state.history, { label, before, after });
    this.store.set({ document: after, history, notice: null });
    this.#display.adopt(after);
    void this.#carve(true);
  }

  /** Back to what this mesh opened with. */
  reset(): void {
    const document = this.document;
    const method = document && findMethod(document.method);
    if (document && method) this.commit({ parameters: startingParameters(method, document) }, 'Reset');
  }

  /** Stops what is running; the shape on the screen stays. */
  cancel(): boolean {
    if (this.store.state.activity.kind === 'idle') return false;
    if (this.#gestureFrom) this.#stoppedAt = this.document;
    this.#runner.cancel();
    return true;
  }

  undo(): boolean {
    return this.#travel(undo(this.store.state.history), 'before');
  }

  redo(): boolean {
    return this.#travel(redo(this.store.state.history), 'after');
  }

  /** The file in a format (default: its own) with the settled shape. Null if it could not be written; a notice says why. */
  async write(
    extension: string,
  ): Promise<{ bytes: Uint8Array<ArrayBuffer>; document: WhittleDocument } | null> {
    await this.#settling;
    if (this.document?.result?.state === 'preview') await this.#carve(false);
    const document = this.document;
    if (!document) return null;
    const { source } = document;
    const task = this.#runner.begin();
    this.store.set({ activity: { kind: 'writing', name: source.name }, notice: null });
    try {
      const positions = document.result?.positions ?? document.mesh.positions;
      const bytes = await this.#runner.patiently(task, () =>
        this.#runner.engine.write(source.bytes, source.name, extension, positions, { signal: task.signal }),
      );
      if (task.current()) this.store.set({ activity: idle });
      return { bytes, document };
    } catch (thrown) {
      this.#fail(task, thrown, () => void this.write(extension));
      return null;
    }
  }

  async #understand(task: Task, bytes: Uint8Array<ArrayBuffer>, name: string): Promise<WhittleDocument> {
    const { engine } = this.#runner;
    const { mesh, format, warnings } = await engine.read(bytes, name, { signal: task.signal });
    const report = await engine.inspect(mesh, { signal: task.signal });
    if (warnings.length > 0 && task.current())
      this.store.set({ notice: { tone: 'note', text: warnings.join(' ') } });
    // A style is put on the next mesh too; other methods may not suit it.
    const before = findMethod(this.document?.method ?? '');
    const method = before && takesStyle(before) ? before : offeredMethods()[0]!;
    const style = this.document?.style ?? null;
    const parameters = startingParameters(method, { report, style });
    return {
      source: { bytes, name, format },
      mesh,
      report,
      method: method.id,
      parameters,
      style,
      result: null,
    };
  }

  #enter(document: WhittleDocument, label: string): void {
    const before = this.document;
    const { history } = this.store.state;
    this.store.set({
      document,
      history: before ? record(history, { label, before, after: document }) : history,
    });
    if (before) this.#releaseUnless(before);
    this.#display.document(document);
  }

  /** From the file's own shape to the end, so that the same file and settings always give the same bits. */
  #carve(watch: boolean): Promise<void> {
    this.#settling = this.#carveNow(watch);
    return this.#settling;
  }

  async #carveNow(watch: boolean): Promise<void> {
    const document = this.document;
    if (!document) return;
    const task = this.#runner.begin();
    try {
      const solved = await this.#solve(task, document, { start: 'rest', frames: watch }, watch);
      if (!task.current()) return;
      const stopped = solved.outcome === 'cancelled';
      // A settling run that was stopped has shown nothing: what is on the screen is the preview, and that is kept.
      const now = this.document;
      if (now && stopped && !watch) this.#keepPreview(now);
      else if (now) this.#take(now, resultOf(solved, stopped ? 'stopped' : 'settled'));
      this.store.set({ activity: idle });
    } catch (thrown) {
      this.#fail(task, thrown, () => void this.#carve(watch));
    }
  }

  /** One warm run on the way of a gesture. */
  async #follow(document: WhittleDocument): Promise<void> {
    const task = this.#runner.begin();
    try {
      const solved = await this.#solve(task, document, { start: 'current', frames: true }, true);
      const now = this.document;
      // A run that was overtaken by a later value or by the settling run still is the nearest there is to its shape.
      if (now?.mesh !== document.mesh || !sameShaping(now, document)) return;
      if (now.result?.state === 'settled') return;
      const state = solved.outcome === 'cancelled' && task.signal.aborted ? 'stopped' : 'preview';
      this.#amend(now, { ...now, result: resultOf(solved, state) });
      if (task.current()) this.store.set({ activity: idle });
    } catch (thrown) {
      this.#fail(task, thrown, () => void this.#carve(false));
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
    this.store.set({ activity: { kind: 'solving', live, iteration: 0, energy } });
    const onFrame = async (frame: Frame) => {
      energy.push(...frame.energy);
      if (!task.current()) return;
      this.store.set({ activity: { kind: 'solving', live, iteration: frame.iteration, energy } });
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
    this.store.set({ document: next, history: amend(this.store.state.history, old, next) });
    this.#display.adopt(next);
  }

  #travel(step: ReturnType<typeof undo>, to: 'before' | 'after'): boolean {
    if (!step) return false;
    this.#gestureFrom = null;
    this.store.set({ history: step.history });
    this.#goTo(step.entry[to]);
    return true;
  }

  #goTo(document: WhittleDocument): void {
    this.#runner.abandon();
    const before = this.document;
    this.store.set({ document, activity: idle, notice: null });
    if (before) this.#releaseUnless(before);
    this.#display.document(document);
  }

  /** The worker need not keep what is not on the screen: it is sent again if it comes back. */
  #releaseUnless(before: WhittleDocument): void {
    if (this.document?.mesh !== before.mesh) this.#runner.engine.release(before.mesh);
  }

  #fail(task: Task, thrown: unknown, again: () => void): void {
    if (!task.current()) return;
    if (task.signal.aborted && !isWorkerLost(thrown)) {
      this.store.set({ activity: idle });
      return;
    }
    const text = toFailure(thrown).message;
    const action = { label: 'Try again', run: again };
    this.store.set({
      activity: idle,
      notice: isWorkerLost(thrown) ? { tone: 'error', text, action } : { tone: 'error', text },
    });
  }
}
