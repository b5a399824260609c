import { type TreeAnswer, TreeKeeper, type TreeRequest } from './tree.ts';

/** Where trees are made. */
export interface TreeThread {
  ask(request: TreeRequest): void;
  onAnswer: (answer: TreeAnswer) => void;
  end(): void;
}

/** A worker, or where none can be started (a page without them, Node) this thread, between two tasks. */
export function startTreeThread(): TreeThread {
  try {
    return new TreeWorker(new Worker(new URL('./tree-worker.ts', import.meta.url), { type: 'module' }));
  } catch {
    return new SameThread();
  }
}

class TreeWorker implements TreeThread {
  readonly #worker: Worker;
  onAnswer: (answer: TreeAnswer) => void = () => {};

  constructor(worker: Worker) {
    this.#worker = worker;
    worker.addEventListener('message', ({ data }: MessageEvent<TreeAnswer>) => this.onAnswer(data));
  }

  ask(request: TreeRequest): void {
    const { positions } = request;
    const transfer =
      request.type === 'build' ? [positions.buffer, request.triangles.buffer] : [positions.buffer];
    this.#worker.postMessage(request, transfer);
  }

  end(): void {
    this.#worker.terminate();
  }
}

/** Answers when the present task is done. */
export class SameThread implements TreeThread {
  readonly #keeper = new TreeKeeper();
  onAnswer: (answer: TreeAnswer) => void = () => {};

  ask(request: TreeRequest): void {
    queueMicrotask(() => this.onAnswer(this.#keeper.answer(request)));
  }

  end(): void {
    this.onAnswer = () => {};
  }
}
