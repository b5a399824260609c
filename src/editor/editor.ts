import { startingParameters } from '../../web/app/offered-methods.ts';
import { idle, type Store } from '../../web/app/store.ts';
import { findMethod } from '../methods/registry.ts';
import { record, redo, undo } from './history.ts';
import { Carver } from './live-solver.ts';
import { type Beginning, beginDocument, type OpenedFile, understandFile } from './open-file.ts';
import type { Display } from './presenter.ts';
import { type Shaping, sameShaping, type WhittleDocument, withShaping } from './project.ts';
import { type Runner, reportFailure } from './task.ts';

/** What a person does to the document: open, shape, settle, cancel, undo, take home. */
export class Workspace {
  readonly store: Store;
  readonly #runner: Runner;
  readonly #display: Display;
  readonly #carver: Carver;
  /** The document as it was when the gesture that is under way began. */
  #gestureFrom: WhittleDocument | null = null;
  /** The settings whose run a person stopped: that shape is kept and not settled after all when the gesture ends. */
  #stoppedAt: Shaping | null = null;

  constructor(store: Store, runner: Runner, display: Display) {
    this.store = store;
    this.#runner = runner;
    this.#display = display;
    this.#carver = new Carver(store, runner, display);
  }

  get document(): WhittleDocument | null {
    return this.store.state.document;
  }

  /** Opens a file and carves it. The mesh that was there stays until the new one is known to be good. */
  async open(bytes: Uint8Array<ArrayBuffer>, name: string, begin: Beginning = {}): Promise<void> {
    this.#runner.cancel();
    const task = this.#runner.begin();
    this.#gestureFrom = null;
    this.store.set({ activity: { kind: 'opening', name }, notice: null });
    try {
      const file = await this.#runner.patiently(task, () =>
        understandFile(this.#runner.engine, bytes, name, task.signal),
      );
      if (!task.current()) return;
      this.#enter(file, begin);
    } catch (thrown) {
      reportFailure(this.store, task, thrown, () => void this.open(bytes, name, begin));
      return;
    }
    await this.#carver.carve(true);
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
    void this.#carver.follow(next);
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
    void this.#carver.carve(false);
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
    void this.#carver.carve(true);
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
    await this.#carver.settling;
    if (this.document?.result?.state === 'preview') await this.#carver.carve(false);
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
      reportFailure(this.store, task, thrown, () => void this.write(extension));
      return null;
    }
  }

  #enter(file: OpenedFile, begin: Beginning): void {
    if (file.warnings.length > 0) this.store.set({ notice: { tone: 'note', text: file.warnings.join(' ') } });
    const before = this.document;
    const document = beginDocument(file, begin, before);
    const label = `Open ${file.source.name}`;
    const { history } = this.store.state;
    this.store.set({
      document,
      history: before ? record(history, { label, before, after: document }) : history,
    });
    if (before) this.#releaseUnless(before);
    this.#display.document(document);
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
}
