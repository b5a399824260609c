import { WhittleError } from '../mesh/failure.ts';
import type { MeshReport } from '../mesh/mesh.ts';
import type { ClientPort } from './port.ts';
import type { CallName, Calls, FromWorker, Progress, Request, ToWorker } from './protocol.ts';
import { transferOf } from './protocol.ts';

/** A request without its id, which the connection gives. */
export type Ask<Name extends CallName> = { type: Name } & Calls[Name]['ask'];

/** Sees progress; may take its time, the next comes when it is done. */
export type ProgressListener = (progress: Progress) => void | Promise<void>;

interface Pending {
  readonly resolve: (value: Calls[CallName]['answer']) => void;
  readonly reject: (reason: unknown) => void;
  readonly onProgress: ProgressListener | undefined;
}

/**
 * One worker from its start to its end: who waits for which answer, and which meshes it knows. When it ends, everyone who
 * waits is rejected with `worker-lost`; a new connection starts from nothing.
 */
export class Connection {
  /** Reports by mesh key: what this worker has been told to load. */
  readonly loaded = new Map<number, Promise<MeshReport>>();
  readonly #port: ClientPort;
  readonly #onLost: () => void;
  readonly #pending = new Map<number, Pending>();
  #lastId = 0;
  #lost: WhittleError | undefined;

  constructor(port: ClientPort, onLost: () => void) {
    this.#port = port;
    this.#onLost = onLost;
    port.onmessage = (event) => this.#receive(event.data as FromWorker);
    port.onerror = (event) => this.end(event.message || 'its script could not be loaded or run');
    port.onmessageerror = () => this.end('a message could not be read');
  }

  /** Sends a request. The id serves to cancel it. */
  ask<Name extends CallName>(
    request: Ask<Name>,
    onProgress?: ProgressListener,
  ): { id: number; answer: Promise<Calls[Name]['answer']> } {
    const id = ++this.#lastId;
    const answer = new Promise<Calls[CallName]['answer']>((resolve, reject) => {
      if (this.#lost) return reject(this.#lost);
      this.#pending.set(id, { resolve, reject, onProgress });
      // What cannot be cloned throws here and rejects the promise; nobody would ever answer it.
      try {
        this.#send({ ...request, id } as unknown as Request);
      } catch (thrown) {
        this.#pending.delete(id);
        reject(thrown);
      }
    });
    // The worker answers a request with the answer of its own kind.
    return { id, answer: answer as Promise<Calls[Name]['answer']> };
  }

  /** Asks a run to stop at its next step. It still answers. */
  cancel(id: number): void {
    if (this.#pending.has(id)) this.#send({ type: 'cancel', id });
  }

  /** Ends the worker and rejects all that is pending with `worker-lost`. */
  end(why: string): void {
    if (this.#lost) return;
    this.#lost = new WhittleError(
      'worker-lost',
      `The worker that edits the mesh has stopped (${why}). Nothing of your work is lost; try again and a new one starts.`,
    );
    this.#port.terminate();
    for (const { reject } of this.#pending.values()) reject(this.#lost);
    this.#pending.clear();
    this.#onLost();
  }

  #send(message: ToWorker): void {
    if (!this.#lost) this.#port.postMessage(message, transferOf(message));
  }

  #receive(message: FromWorker): void {
    if (message.type === 'lost') {
      this.end(message.failure.message);
      return;
    }
    const pending = this.#pending.get(message.id);
    if (!pending) return;
    if (message.type === 'progress') {
      void this.#show(message.id, message.progress, pending.onProgress);
      return;
    }
    this.#pending.delete(message.id);
    if (message.type === 'answer') pending.resolve(message.value);
    else pending.reject(WhittleError.from(message.failure));
  }

  async #show(id: number, progress: Progress, onProgress: ProgressListener | undefined): Promise<void> {
    try {
      await onProgress?.(progress);
    } finally {
      const positions = progress.kind === 'iterating' ? progress.positions : undefined;
      this.#send(positions ? { type: 'progress-seen', id, positions } : { type: 'progress-seen', id });
    }
  }
}
