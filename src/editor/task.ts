import { idle, type Store } from '../../web/app/store.ts';
import type { Engine, SolveOptions } from '../engine/client.ts';
import type { Solved, SolveSettings } from '../engine/protocol.ts';
import { toFailure, WhittleError } from '../mesh/failure.ts';
import type { Mesh } from '../mesh/mesh.ts';

/** One attempt at something that may be cancelled or overtaken by a later one. */
export interface Task {
  readonly signal: AbortSignal;
  /** False once a later task began or the page moved on. */
  readonly current: () => boolean;
}

/** The engine with a short patience: one task at a time counts, and a dead worker costs one retry. */
export class Runner {
  readonly engine: Engine;
  #controller: AbortController | null = null;
  #generation = 0;

  constructor(engine: Engine) {
    this.engine = engine;
  }

  /** Begins a task that makes all earlier ones stale. Earlier solves are stopped by the newer one or by {@link cancel}. */
  begin(): Task {
    const generation = ++this.#generation;
    this.#controller = new AbortController();
    return { signal: this.#controller.signal, current: () => generation === this.#generation };
  }

  /** Asks the running task to stop; a solve keeps what it has. */
  cancel(): void {
    this.#controller?.abort();
  }

  /** Stops the running task and forgets what it would answer. */
  abandon(): void {
    this.cancel();
    this.#generation++;
  }

  /** Does it again, once, if the worker died under it and nobody has asked for something else since. */
  async patiently<T>(task: Task, attempt: () => Promise<T>): Promise<T> {
    try {
      return await attempt();
    } catch (thrown) {
      if (!isWorkerLost(thrown) || !task.current() || task.signal.aborted) throw thrown;
      return attempt();
    }
  }

  solve(task: Task, mesh: Mesh, settings: SolveSettings, onFrame?: SolveOptions['onFrame']): Promise<Solved> {
    return this.patiently(task, () =>
      this.engine.solve(mesh, settings, onFrame ? { signal: task.signal, onFrame } : { signal: task.signal }),
    );
  }
}

/**
 * Says why a task failed, and offers to do it again where the worker died under it. Nothing is said of a task that was
 * stopped or overtaken.
 */
export function reportFailure(store: Store, task: Task, thrown: unknown, again: () => void): void {
  if (!task.current()) return;
  if (task.signal.aborted && !isWorkerLost(thrown)) {
    store.set({ activity: idle });
    return;
  }
  const text = toFailure(thrown).message;
  const action = { label: 'Try again', run: again };
  store.set({
    activity: idle,
    notice: isWorkerLost(thrown) ? { tone: 'error', text, action } : { tone: 'error', text },
  });
}

function isWorkerLost(thrown: unknown): boolean {
  return thrown instanceof WhittleError && thrown.code === 'worker-lost';
}
