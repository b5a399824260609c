import type { FilesBeside, Reference, WrittenMesh } from '../io/index.ts';
import { WhittleError } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import { weldOf } from '../mesh/weld.ts';
import { Connection, type ProgressListener } from './connection.ts';
import type { ClientPort } from './port.ts';
import type { ReadResult, Solved, SolveSettings } from './protocol.ts';

export type { ProgressListener } from './connection.ts';

export interface CallOptions {
  /** When it aborts, the call rejects with the signal's reason. */
  readonly signal?: AbortSignal | undefined;
}

export interface FileOptions extends CallOptions {
  /** Files that the mesh file refers to. Default: none. */
  readonly beside?: FilesBeside | undefined;
}

export interface SolveOptions {
  /** When it aborts, the run stops at its next step and the promise *resolves* with outcome 'cancelled' and what there is. */
  readonly signal?: AbortSignal | undefined;
  /**
   * Called with the latest progress; if it returns a promise, the next waits for it (the solve does not). Its `positions`
   * belong to the listener only until then: their buffer goes back to the worker and becomes empty here. Iterations after the
   * last progress are in {@link Solved} alone.
   */
  readonly onProgress?: ProgressListener | undefined;
}

/**
 * The solver behind a worker. Meshes are ordinary objects and the same object is sent only once; treat them as immutable.
 * Every method rejects with a `WhittleError`: the code of what was refused, or `worker-lost` if the worker died under the
 * call. The next call then starts a new worker and gives it again what it needs.
 */
export interface Engine {
  /** Understands a file. The caller keeps `bytes`. */
  read(bytes: Uint8Array<ArrayBuffer>, name: string, options?: FileOptions): Promise<ReadResult>;
  /**
   * The files that a file refers to: data and images of glTF, materials and textures of OBJ. Those that are there already (`beside`)
   * may refer to more. See `gatherBeside`.
   */
  references(
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    options?: FileOptions,
  ): Promise<readonly Reference[]>;
  /** The source file with other positions (#P×3, file order); an own `format` writes a new file. The caller keeps both arrays. */
  write(
    source: Uint8Array<ArrayBuffer>,
    name: string,
    format: string,
    positions: Float64Array<ArrayBuffer>,
    options?: FileOptions,
  ): Promise<WrittenMesh>;
  /** Counts parts, borders and defects, or rejects with what makes the mesh unusable. */
  inspect(mesh: Mesh, options?: CallOptions): Promise<MeshReport>;
  /**
   * Runs a method. A newer `solve` of the same mesh wins: the older one resolves with outcome 'cancelled'. `start: 'current'`
   * continues from the mesh's latest run; if there was none in this worker (it may have died since), from the file's shape.
   */
  solve(mesh: Mesh, settings: SolveSettings, options?: SolveOptions): Promise<Solved>;
  /**
   * A field of the mesh's latest run, by its name in {@link Solved.fields}: #P in the file's order, or #F, or for lines #×2 positions. Rejects with
   * `bad-parameter` where there is none.
   */
  field(mesh: Mesh, name: string): Promise<Float64Array<ArrayBuffer>>;
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

  async read(
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    { signal, beside }: FileOptions = {},
  ): Promise<ReadResult> {
    return unlessAborted(signal, () => this.#connect().ask({ type: 'read', bytes, name, beside }).answer);
  }

  async references(
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    { signal, beside }: FileOptions = {},
  ): Promise<readonly Reference[]> {
    return unlessAborted(
      signal,
      () => this.#connect().ask({ type: 'references', bytes, name, beside }).answer,
    );
  }

  async write(
    source: Uint8Array<ArrayBuffer>,
    name: string,
    format: string,
    positions: Float64Array<ArrayBuffer>,
    { signal, beside }: FileOptions = {},
  ): Promise<WrittenMesh> {
    return unlessAborted(
      signal,
      () => this.#connect().ask({ type: 'write', source, name, format, positions, beside }).answer,
    );
  }

  async inspect(mesh: Mesh, options: CallOptions = {}): Promise<MeshReport> {
    return unlessAborted(options.signal, () => this.#load(this.#connect(), mesh));
  }

  async solve(mesh: Mesh, settings: SolveSettings, options: SolveOptions = {}): Promise<Solved> {
    const connection = this.#connect();
    const key = this.#keyOf(mesh);
    await this.#load(connection, mesh);
    const { id, answer } = connection.ask({ type: 'solve', key, settings }, options.onProgress);
    const cancel = () => connection.cancel(id);
    if (options.signal?.aborted) cancel();
    options.signal?.addEventListener('abort', cancel);
    try {
      return await answer;
    } finally {
      options.signal?.removeEventListener('abort', cancel);
    }
  }

  async field(mesh: Mesh, name: string): Promise<Float64Array<ArrayBuffer>> {
    const connection = this.#connect();
    const key = this.#keyOf(mesh);
    await this.#load(connection, mesh);
    return connection.ask({ type: 'field', key, name }).answer;
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
