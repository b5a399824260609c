import { toFailure, WhittleError } from '../mesh/failure.ts';
import { type EditorStore, idle } from './state.ts';

/** One attempt at something that may be cancelled or overtaken by a later one. */
export interface Task {
  readonly signal: AbortSignal;
  /** False once a later task began or the editor moved on. */
  readonly current: () => boolean;
}

/** One task at a time counts. */
export class Tasks {
  #controller: AbortController | null = null;
  #generation = 0;

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
}

/** Does it again, once, if the worker died under it and nobody has asked for something else since. */
export async function patiently<T>(task: Task, attempt: () => Promise<T>): Promise<T> {
  try {
    return await attempt();
  } catch (thrown) {
    if (!isWorkerLost(thrown) || !task.current() || task.signal.aborted) throw thrown;
    return attempt();
  }
}

/**
 * Says why a task failed, and offers to do it again where the worker died under it. Nothing is said of a task that was
 * stopped or overtaken.
 */
export function reportFailure(store: EditorStore, task: Task, thrown: unknown, again: () => void): void {
  if (!task.current()) return;
  if (task.signal.aborted && !isWorkerLost(thrown)) {
    store.set({ activity: idle });
    return;
  }
  const { code, message: text } = toFailure(thrown);
  const notice = { tone: 'error', code, text } as const;
  const action = { label: 'Try again', run: again };
  store.set({ activity: idle, notice: isWorkerLost(thrown) ? { ...notice, action } : notice });
}

function isWorkerLost(thrown: unknown): boolean {
  return thrown instanceof WhittleError && thrown.code === 'worker-lost';
}
