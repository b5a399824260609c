import { toFailure, WhittleError } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import { checkParameters } from '../methods/check.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import { findMethod, methods } from '../methods/registry.ts';
import { didYouMean } from '../methods/suggest.ts';
import type { Core } from './core-api.ts';
import { encodeValues } from './encode.ts';
import { createHop } from './hop.ts';
import { LoadedMesh } from './loaded-mesh.ts';
import type { ServerPort } from './port.ts';
import { ProgressGate } from './progress-gate.ts';
import type {
  CallName,
  Calls,
  FromWorker,
  Progress,
  Request,
  Solved,
  SolveSettings,
  ToWorker,
} from './protocol.ts';
import { transferOf } from './protocol.ts';
import { Run, runToEnd } from './run-loop.ts';
import type { Services } from './services.ts';
import { CoreTrap } from './trap.ts';

/** Answers the requests of `protocol.ts` on a port, the same in a web worker and in Node. */
export function serve(port: ServerPort, services: Services): void {
  const server = new Server(port, services);
  port.onmessage = (event) => server.receive(event.data as ToWorker);
}

interface Entry {
  readonly mesh: LoadedMesh;
  /** The newest run; those before it have been told to stop. */
  latest: Run | undefined;
}

class Server {
  readonly #port: ServerPort;
  readonly #services: Services;
  readonly #hop = createHop();
  readonly #entries = new Map<number, Entry>();
  readonly #runs = new Map<number, Run>();
  #core: Promise<Core> | undefined;
  #isLost = false;

  constructor(port: ServerPort, services: Services) {
    this.#port = port;
    this.#services = services;
  }

  receive(message: ToWorker): void {
    if (this.#isLost) return;
    if (message.type === 'cancel') this.#runs.get(message.id)?.cancel();
    else if (message.type === 'progress-seen') this.#runs.get(message.id)?.progress.seen(message.positions);
    else void this.#answer(message);
  }

  async #answer(request: Request): Promise<void> {
    const { id } = request;
    try {
      this.#post({ type: 'answer', id, value: await this.#carryOut(request) });
    } catch (thrown) {
      const failure = thrown instanceof CoreTrap ? thrown.failure : toFailure(thrown);
      this.#post({ type: 'failure', id, failure });
      if (thrown instanceof CoreTrap) this.#lose(thrown);
    }
  }

  /** Must register a run before anything asynchronous: its cancel may be the next message. */
  #carryOut(request: Request): Calls[CallName]['answer'] | Promise<Calls[CallName]['answer']> {
    switch (request.type) {
      case 'read':
        return this.#services.readMesh(request.bytes, request.name, request.beside);
      case 'references':
        return this.#services.referencesOf(request.bytes, request.name, request.beside);
      case 'write':
        return this.#write(request);
      case 'load':
        return this.#load(request.key, request.mesh);
      case 'unload':
        return this.#unload(request.key);
      case 'solve':
        return this.#solve(request.id, request.key, request.settings);
      case 'field':
        return this.#entry(request.key).mesh.field(request.name);
    }
  }

  #write({ source, name, format, positions, beside }: Calls['write']['ask']) {
    return this.#services.writeMesh(source, name, format, positions, beside);
  }

  async #load(key: number, mesh: Mesh): Promise<MeshReport> {
    this.#core ??= this.#services.loadCore();
    const core = await this.#core.catch((thrown) => {
      this.#core = undefined;
      throw thrown;
    });
    const loaded = new LoadedMesh(core, mesh);
    await this.#unload(key);
    this.#entries.set(key, { mesh: loaded, latest: undefined });
    return loaded.report;
  }

  async #unload(key: number): Promise<null> {
    const entry = this.#entries.get(key);
    if (!entry) return null;
    this.#entries.delete(key);
    entry.latest?.cancel();
    await entry.latest?.ended;
    entry.mesh.free();
    return null;
  }

  async #solve(id: number, key: number, settings: SolveSettings): Promise<Solved> {
    const entry = this.#entry(key);
    // A request that is refused here does not disturb the run before it.
    const method = checkedMethod(settings);
    const values = encodeValues(method, settings.parameters, entry.mesh.weld);

    const previous = entry.latest;
    const run = new Run(settings, this.#gate(id, entry.mesh, settings));
    previous?.supersede();
    entry.latest = run;
    this.#runs.set(id, run);
    try {
      await previous?.ended;
      return await runToEnd(entry.mesh, values, run, this.#hop);
    } catch (thrown) {
      // Positions after a failure can be anything; the next run may ask to start from them.
      if (thrown instanceof WhittleError) entry.mesh.restart();
      throw thrown;
    } finally {
      this.#runs.delete(id);
      if (entry.latest === run) entry.latest = undefined;
      run.end();
    }
  }

  #entry(key: number): Entry {
    const entry = this.#entries.get(key);
    if (entry) return entry;
    throw new WhittleError('internal', 'The mesh was released. Please report it.');
  }

  #gate(id: number, { copyPositions }: LoadedMesh, { positions }: SolveSettings): ProgressGate {
    const post = (progress: Progress) => this.#post({ type: 'progress', id, progress });
    return new ProgressGate({ withPositions: positions, copyPositions, post }, performance.now());
  }

  /** Other meshes live in the same broken heap: all runs stop without an answer, and the client starts a new worker. */
  #lose(trap: CoreTrap): void {
    this.#post({ type: 'lost', failure: trap.failure });
    this.#isLost = true;
    for (const run of this.#runs.values()) run.cancel();
    this.#port.close();
  }

  #post(message: FromWorker): void {
    if (!this.#isLost) this.#port.postMessage(message, transferOf(message));
  }
}

/** @throws WhittleError `unknown-method`, `bad-parameter`, `bad-handles`, `bad-planes` */
function checkedMethod({ method: id, parameters }: SolveSettings): MethodDescriptor {
  const method = findMethod(id);
  if (!method) {
    const ids = methods.map((known) => known.id);
    throw new WhittleError('unknown-method', `There is no method “${id}”.${didYouMean(id, ids)}`);
  }
  const problem = checkParameters(method, parameters);
  if (problem) throw new WhittleError(problem.code, problem.message);
  return method;
}
