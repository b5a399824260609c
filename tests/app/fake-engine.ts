import type { Engine } from '../../src/engine/client.ts';
import type { Frame, ReadResult, Solved } from '../../src/engine/protocol.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import type { Mesh, MeshReport } from '../../src/mesh/mesh.ts';

/** What a fake solve waits for between steps; a test may hold it. */
export interface FakeOptions {
  readonly steps?: number;
  readonly pause?: () => Promise<void>;
}

/** A tetrahedron, whatever the file says. */
export function tetrahedron(): Mesh {
  return {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
    triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
  };
}

/**
 * An engine without a core, for tests of the page's logic: every vertex moves towards itself times (1 + λ), halving the
 * distance each step; `broken` files are refused; the next calls die when told so.
 */
export class FakeEngine implements Engine {
  readonly calls: string[] = [];
  /** How many of the next calls shall lose their worker. */
  deaths = 0;
  readonly #steps: number;
  readonly #pause: () => Promise<void>;
  readonly #running = new Map<Mesh, AbortController>();

  constructor({ steps = 4, pause = () => Promise.resolve() }: FakeOptions = {}) {
    this.#steps = steps;
    this.#pause = pause;
  }

  async read(_bytes: Uint8Array<ArrayBuffer>, name: string): Promise<ReadResult> {
    this.#call('read');
    if (name.includes('broken'))
      throw new WhittleError('malformed-file', `${name}, line 3: not a number.`, 3);
    return { mesh: tetrahedron(), format: 'obj', warnings: [] };
  }

  async write(): Promise<Uint8Array<ArrayBuffer>> {
    this.#call('write');
    return Uint8Array.of(1, 2, 3);
  }

  async inspect(mesh: Mesh): Promise<MeshReport> {
    this.#call('inspect');
    return {
      vertices: mesh.positions.length / 3,
      faces: mesh.triangles.length / 3,
      components: 1,
      boundaryEdges: 0,
      nonManifoldEdges: 0,
      degenerateFaces: 0,
      duplicateFaces: 0,
      isolatedVertices: 0,
      min: [0, 0, 0],
      max: [1, 1, 1],
    };
  }

  async solve(
    mesh: Mesh,
    settings: Parameters<Engine['solve']>[1],
    options: Parameters<Engine['solve']>[2] = {},
  ): Promise<Solved> {
    this.#call(`solve ${settings.start} ${settings.parameters.lambda}`);
    this.#running.get(mesh)?.abort();
    const own = new AbortController();
    this.#running.set(mesh, own);
    const stopped = () => own.signal.aborted || options.signal?.aborted;
    let share = 0;
    let iteration = 0;
    while (iteration < this.#steps && !stopped()) {
      await this.#pause();
      iteration++;
      share = 1 - 0.5 ** iteration;
      const frame: Frame = { iteration, energy: [1 - share], change: [1 - share] };
      const positions = moved(mesh, settings.parameters.lambda as number, share);
      await options.onFrame?.(settings.frames ? { ...frame, positions } : frame);
    }
    const outcome = stopped() ? 'cancelled' : 'converged';
    const positions = moved(mesh, settings.parameters.lambda as number, outcome === 'converged' ? 1 : share);
    return {
      outcome,
      iterations: iteration,
      energy: [1, 0],
      positions,
      milliseconds: { prepare: 0, solve: 1 },
      warnings: [],
    };
  }

  release(): void {
    this.calls.push('release');
  }

  dispose(): void {}

  #call(name: string): void {
    this.calls.push(name);
    if (this.deaths > 0) {
      this.deaths--;
      throw new WhittleError('worker-lost', 'The worker has stopped; try again.');
    }
  }
}

function moved(mesh: Mesh, lambda: number, share: number): Float64Array<ArrayBuffer> {
  return mesh.positions.map((x) => x * (1 + lambda * share)) as Float64Array<ArrayBuffer>;
}
