import type {
  Core,
  CoreField,
  CoreReport,
  CoreSession,
  Preparation,
  Step,
} from '../../src/engine/core-api.ts';
import type { EncodedValues } from '../../src/engine/encode.ts';
import type { Services } from '../../src/engine/services.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Encoded } from '../../src/methods/values/parameter.ts';

/** Values of `lambda` that make the fake core misbehave at its third step. */
export const trapLambda = 66;
export const failLambda = 67;

export interface FakeOptions {
  /** Each step computes (blocks) this long. */
  readonly stepMilliseconds?: number;
  /** So does each stage of preparing. */
  readonly prepareMilliseconds?: number;
  /** How many stages preparing has; default 1. */
  readonly prepareStages?: number;
}

/**
 * A core without wasm: every vertex goes half of the way to its handle, or to half of its rest position, at each step.
 * What it was asked is in `log`.
 */
export class FakeCore implements Core {
  readonly log: string[] = [];
  readonly handles: (Encoded | undefined)[] = [];
  steps = 0;
  opened = 0;
  freed = 0;
  readonly options: FakeOptions;

  constructor(options: FakeOptions = {}) {
    this.options = options;
  }

  open(): CoreSession {
    this.opened++;
    return new FakeSession(this);
  }

  methods(): ReturnType<Core['methods']> {
    return [];
  }

  heapBytes(): number {
    return 0;
  }
}

class FakeSession implements CoreSession {
  readonly #core: FakeCore;
  #rest = new Float64Array();
  #current = new Float64Array();
  #target = new Float64Array();
  #values: EncodedValues = new Map();
  #iteration = 0;
  #prepared = 0;

  constructor(core: FakeCore) {
    this.#core = core;
  }

  load(positions: Float64Array, triangles: Uint32Array, sourceVertices?: Uint32Array): CoreReport {
    this.#core.log.push('load');
    const bad = positions.findIndex((coordinate) => !Number.isFinite(coordinate));
    if (bad >= 0) {
      const welded = Math.floor(bad / 3);
      const vertex = sourceVertices?.[welded] ?? welded;
      throw new WhittleError('not-finite', `vertex ${vertex} is not finite; repair the file`, vertex);
    }
    this.#rest = positions.slice();
    this.#current = positions.slice();
    return {
      ...{
        vertices: positions.length / 3,
        faces: triangles.length / 3,
        components: 1,
        typicalPart: positions.length / 3,
        boundaryEdges: 0,
      },
      ...{ nonManifoldEdges: 0, degenerateFaces: 0, isolatedVertices: 0, farVertices: 0 },
      ...{ min: [0, 0, 0] as const, max: [1, 1, 1] as const },
    };
  }

  configure(method: string, values: EncodedValues): void {
    const handles = values.get('handles');
    this.#core.log.push(`configure ${method}`);
    this.#core.handles.push(handles);
    this.#values = values;
    this.#iteration = 0;
    this.#prepared = 0;
    this.#target = this.#rest.map((coordinate) => coordinate / 2);
    handles?.indices.forEach((vertex, entry) => {
      this.#target.set(handles.numbers.subarray(3 * entry, 3 * entry + 3), 3 * vertex);
    });
  }

  restart(): void {
    this.#core.log.push('restart');
    this.#current = this.#rest.slice();
  }

  /** Prepares in {@link prepareStages} stages, each as long as the options say. */
  prepareNext(): Preparation {
    this.#core.log.push('prepare');
    this.#prepared++;
    const until = performance.now() + (this.#core.options.prepareMilliseconds ?? 0);
    while (performance.now() < until);
    const { prepareStages = 1 } = this.#core.options;
    return { stage: `stage ${this.#prepared}`, share: Math.min(1, this.#prepared / prepareStages) };
  }

  warnings(): string[] {
    return [];
  }

  fields(): readonly CoreField[] {
    return [
      { name: 'height', label: 'Height', per: 'vertex', unit: '' },
      { name: 'creases', label: 'Creases', per: 'line', unit: '', count: 2 },
    ];
  }

  copyField(name: string, into: Float64Array): void {
    into.forEach((_, v) => {
      into[v] = name === 'height' ? this.#current[3 * v + 2]! : v;
    });
  }

  step(): Step {
    const until = performance.now() + (this.#core.options.stepMilliseconds ?? 0);
    this.#core.steps++;
    this.#iteration++;
    const [lambda, maxIterations, tolerance] = ['lambda', 'maxIterations', 'tolerance'].map(
      (name) => this.#values.get(name)?.numbers[0],
    );
    if (this.#iteration === 3 && lambda === trapLambda) throw new WebAssembly.RuntimeError('unreachable');
    if (this.#iteration === 3 && lambda === failLambda) {
      this.#current.fill(Number.NaN);
      throw new WhittleError('numerical-failure', 'The system cannot be factorized; use a smaller λ.');
    }
    let energy = 0;
    let change = 0;
    for (let c = 0; c < this.#current.length; c++) {
      const way = this.#target[c]! - this.#current[c]!;
      energy += way * way;
      change = Math.max(change, Math.abs(way));
      this.#current[c]! += way / 2;
    }
    while (performance.now() < until);
    if (change < (tolerance ?? 3e-3)) return { outcome: 'converged', energy, change };
    const isOver = this.#iteration >= (maxIterations ?? 1000);
    return { outcome: isOver ? 'iteration-limit' : 'running', energy, change };
  }

  copyPositions(into: Float64Array): void {
    into.set(this.#current);
  }

  free(): void {
    this.#core.freed++;
  }
}

/** Files of the fake: `read` gives back the bytes as coordinates, `write` refuses a 'bad' format. */
export function fakeServices(core: FakeCore): Services {
  return {
    loadCore: async () => core,
    readMesh: (bytes) => ({ mesh: tetrahedron([...bytes]), format: 'off', warnings: [] }),
    writeMesh: (source, _name, format, positions) => {
      if (format === 'bad') throw new WhittleError('unknown-format', 'There is no format “bad”.');
      return { bytes: new Uint8Array([...source, ...positions]), warnings: ['no more than that'] };
    },
    referencesOf: (_bytes, name, beside) => [{ path: `${name}.${beside?.size ?? 0}`, isShape: true }],
  };
}

/** Four corners; corner 0 is stored twice (positions 0 and 2), hence five positions and four welded vertices. */
export function tetrahedron(positions = [0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 8]): Mesh {
  return {
    positions: new Float64Array(positions),
    triangles: new Uint32Array([0, 3, 1, 2, 1, 4, 1, 3, 4, 3, 0, 4]),
  };
}
