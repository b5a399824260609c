import { WhittleError } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import { weldOf } from '../mesh/weld.ts';
import { Connection, type FrameListener } from './connection.ts';
import type { ClientPort } from './port.ts';
import type { ReadResult, Solved, SolveSettings } from './protocol.ts';

export type { FrameListener } from './connection.ts';

export interface CallOptions {
  /** When it aborts, the call rejects with the signal's reason. */
  readonly signal?: AbortSignal | undefined;
}

export interface SolveOptions {
  /** When it aborts, the run stops at its next step and the promise *resolves* with outcome 'cancelled' and what there is. */
  readonly signal?: AbortSignal | undefined;
  /**
   * Called with the latest frame; if it returns a promise, the next frame waits for it (the solve does not). The frame's
   * `positions` belong to the listener only until then: their buffer goes back to the worker and becomes empty here.
   * Iterations after the last frame are in {@link Solved} alone.
   */
  readonly onFrame?: FrameListener | undefined;
}

/**
 * The solver behind a worker. Meshes are ordinary objects and the same object is sent only once; treat them as immutable.
 * Every method rejects with a `WhittleError`: the code of what was refused, or `worker-lost` if the worker died under the
 * call. The next call then starts a new worker and gives it again what it needs.
 */
export interface Engine {
  /** Understands a file. The caller keeps `bytes`. */
  read(bytes: Uint8Array<ArrayBuffer>, name: string, options?: CallOptions): Promise<ReadResult>;
  /** The source file with other positions (#P×3, file order); an own `format` writes a new file. The caller keeps both arrays. */
  write(
    source: Uint8Array<ArrayBuffer>,
    name: string,
    format: string,
    positions: Float64Array<ArrayBuffer>,
    options?: CallOptions,
  ): Promise<Uint8Array<ArrayBuffer>>;
  /** Counts parts, borders and defects, or rejects with what makes the mesh unusable. */
  inspect(mesh: Mesh, options?: CallOptions): Promise<MeshReport>;
  /**
   * Runs a method. A newer `solve` of the same mesh wins: the older one resolves with outcome 'cancelled'. `start: 'current'`
   * continues from the mesh's latest run; if there was none in this worker (it may have died since), from the file's shape.
   */
  solve(mesh: Mesh, settings: SolveSettings, options?: SolveOptions): Promise<Solved>;
  /** Frees what the worker holds for a mesh. The mesh may be used again and is then sent again. */
  release(mesh: Mesh): void;
  /** Ends the worker. Pending and later calls reject with `worker-lost`. */
  dispose(): void;
}

export interface EngineOptions {
  /** Starts a worker; called at the first request and again after each loss. */
  readonly spawn: () => ClientPort;
}

export function createEngine({ spawn }: EngineOptions): Engine {
  return new WorkerEngine(spawn);
}

class WorkerEngine implements Engine {
  readonly #spawn: () => ClientPort;
  readonly #keys = new WeakMap<Mesh, number>();
  #lastKey = 0;
  #connection: Connection | undefined;
  #disposed = false;

  constructor(spawn: () => ClientPort) {
    this.#spawn = spawn;
  }

  async read(bytes: Uint8Array<ArrayBuffer>, name: string, options: CallOptions = {}): Promise<ReadResult> {
    return unlessAborted(options.signal, () => this.#connect().ask({ type: 'read', bytes, name }).answer);
  }

  async write(
    source: Uint8Array<ArrayBuffer>,
    name: string,
    format: string,
    positions: Float64Array<ArrayBuffer>,
    options: CallOptions = {},
  ): Promise<Uint8Array<ArrayBuffer>> {
    return unlessAborted(
      options.signal,
      () => this.#connect().ask({ type: 'write', source, name, format, positions }).answer,
    );
  }

  async inspect(mesh: Mesh, options: CallOptions = {}): Promise<MeshReport> {
    return unlessAborted(options.signal, () => this.#load(this.#connect(), mesh));
  }

  async solve(mesh: Mesh, settings: SolveSettings, options: SolveOptions = {}): Promise<Solved> {
    const connection = this.#connect();
    const key = this.#keyOf(mesh);
    await this.#load(connection, mesh);
    const { id, answer } = connection.ask({ type: 'solve', key, settings }, options.onFrame);
    const cancel = () => connection.cancel(id);
    if (options.signal?.aborted) cancel();
    options.signal?.addEventListener('abort', cancel);
    try {
      return await answer;
    } finally {
      options.signal?.removeEventListener('abort', cancel);
    }
  }

  release(mesh: Mesh): void {
    const connection = this.#connection;
    const key = this.#keys.get(mesh) ?? 0;
    const loading = connection?.loaded.get(key);
    if (!connection || !loading) return;
    connection.loaded.delete(key);
    // Should the mesh come back, its new load must not meet this unload.
    this.#keys.delete(mesh);
    // Nobody waits for this; a worker that refused the mesh or dies meanwhile holds nothing.
    loading.then(() => connection.ask({ type: 'unload', key }).answer).catch(() => {});
  }

  dispose(): void {
    this.#disposed = true;
    this.#connection?.end('it was shut down');
  }

  #connect(): Connection {
    if (this.#disposed) {
      throw new WhittleError('worker-lost', 'This engine was shut down; create a new one to go on.');
    }
    this.#connection ??= new Connection(this.#start(), () => {
      this.#connection = undefined;
    });
    return this.#connection;
  }

  #start(): ClientPort {
    try {
      return this.#spawn();
    } catch (thrown) {
      const why = thrown instanceof Error ? thrown.message : String(thrown);
      throw new WhittleError('worker-lost', `The worker that edits the mesh could not be started (${why}).`);
    }
  }

  /** Gives a mesh to this worker unless it has it. A refused mesh is asked again the next time. */
  #load(connection: Connection, mesh: Mesh): Promise<MeshReport> {
    const key = this.#keyOf(mesh);
    const known = connection.loaded.get(key);
    if (known) return known;
    // Colours and texture coordinates stay here: the solver has no use for them.
    const { positions, triangles } = mesh;
    const { answer } = connection.ask({
      type: 'load',
      key,
      mesh: { positions, triangles, weld: weldOf(mesh) },
    });
    connection.loaded.set(key, answer);
    answer.catch(() => connection.loaded.delete(key));
    return answer;
  }

  #keyOf(mesh: Mesh): number {
    const key = this.#keys.get(mesh) ?? ++this.#lastKey;
    this.#keys.set(mesh, key);
    return key;
  }
}

/** The call's promise, or a rejection with the signal's reason if that comes first. */
function unlessAborted<T>(signal: AbortSignal | undefined, call: () => Promise<T>): Promise<T> {
  if (!signal) return call();
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const abort = () => reject(signal.reason);
    signal.addEventListener('abort', abort, { once: true });
    call()
      .then(resolve, reject)
      .finally(() => signal.removeEventListener('abort', abort));
  });
}
