import { type FailureCode, WhittleError } from '../mesh/failure.ts';
import type { MeshReport } from '../mesh/mesh.ts';
import type { Core, CoreSession, Step } from './core-api.ts';
import type { EncodedValues } from './encode.ts';
import type { WasmHeap } from './wasm-heap.ts';
import type { WasmModule } from './wasm-module.ts';
import { WasmParameters } from './wasm-parameters.ts';

const outcomes = ['running', 'converged', 'iteration-limit', 'stalled'] as const;

/** A session of the core, by calls of the C interface. */
export class WasmSession implements CoreSession {
  readonly #module: WasmModule;
  readonly #heap: WasmHeap;
  readonly #methods: Core['methods'];
  readonly #handle: number;
  readonly #parameters: WasmParameters;
  readonly #stepNumbers = new Float64Array(3);

  /** @param methods the core's own list, whose parameters a method is configured by */
  constructor(module: WasmModule, heap: WasmHeap, methods: Core['methods']) {
    this.#module = module;
    this.#heap = heap;
    this.#methods = methods;
    this.#handle = module._whittle_create();
    this.#parameters = new WasmParameters(module, heap, this.#handle);
  }

  load(positions: Float64Array, triangles: Uint32Array): MeshReport {
    const load = (positionsAt: number, trianglesAt: number) =>
      this.#module._whittle_load(
        this.#handle,
        positionsAt,
        positions.length / 3,
        trianglesAt,
        triangles.length / 3,
      );
    this.#check(this.#heap.withCopies([positions, triangles], load));
    return this.#report();
  }

  configure(method: string, values: EncodedValues): void {
    this.#check(this.#heap.withString(method, (name) => this.#module._whittle_select(this.#handle, name)));
    const info = this.#methods().find((candidate) => candidate.id === method)!;
    for (const parameter of info.parameters)
      this.#check(this.#parameters.set(parameter, values.get(parameter.name)));
  }

  restart(): void {
    this.#module._whittle_restart(this.#handle);
  }

  prepare(): void {
    this.#check(this.#module._whittle_prepare(this.#handle));
  }

  step(): Step {
    let code = 0;
    this.#heap.readNumbers(this.#stepNumbers, (address) => {
      code = this.#module._whittle_step(this.#handle, address);
    });
    this.#check(code);
    const [outcome, energy, change] = this.#stepNumbers as unknown as [number, number, number];
    return { outcome: outcomes[outcome]!, energy, change };
  }

  copyPositions(into: Float64Array): void {
    this.#heap.readNumbers(into, (address) => this.#module._whittle_positions(this.#handle, address));
  }

  free(): void {
    this.#module._whittle_destroy(this.#handle);
  }

  #report(): MeshReport {
    const numbers = new Float64Array(14);
    this.#heap.readNumbers(numbers, (address) => this.#module._whittle_report(this.#handle, address));
    const at = (index: number): number => numbers[index]!;
    return {
      vertices: at(0),
      faces: at(1),
      components: at(2),
      boundaryEdges: at(3),
      nonManifoldEdges: at(4),
      degenerateFaces: at(5),
      duplicateFaces: at(6),
      isolatedVertices: at(7),
      min: [at(8), at(9), at(10)],
      max: [at(11), at(12), at(13)],
    };
  }

  /** Turns a code of the core into the error that carries its sentence. */
  #check(code: number): void {
    if (code === 0) return;
    const name = this.#heap.readString(this.#module._whittle_code_name(code)) as FailureCode;
    const message = this.#heap.readString(this.#module._whittle_message(this.#handle));
    const element = this.#module._whittle_element(this.#handle);
    throw new WhittleError(name, message, element < 0 ? undefined : element);
  }
}
