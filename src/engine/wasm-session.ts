import { type FailureCode, WhittleError } from '../mesh/failure.ts';
import type { Encoded } from '../methods/values/parameter.ts';
import type { CoreField, CoreMethod, CoreReport, CoreSession, Preparation, Step } from './core-api.ts';
import type { EncodedValues } from './encode.ts';
import type { WasmHeap } from './wasm-heap.ts';
import type { WasmModule } from './wasm-module.ts';

const unset: Encoded = { name: '', numbers: new Float64Array(), indices: new Uint32Array() };

/** A session of the core, by calls of the C interface. */
export class WasmSession implements CoreSession {
  readonly #module: WasmModule;
  readonly #heap: WasmHeap;
  readonly #methods: readonly CoreMethod[];
  readonly #handle: number;
  readonly #share = new Float64Array(1);
  readonly #stepNumbers = new Float64Array(2);

  /** @param methods the core's own list, whose parameters a method is configured by */
  constructor(module: WasmModule, heap: WasmHeap, methods: readonly CoreMethod[]) {
    this.#module = module;
    this.#heap = heap;
    this.#methods = methods;
    this.#handle = module._whittle_create();
  }

  load(
    positions: Float64Array,
    triangles: Uint32Array,
    sourceVertices?: Uint32Array,
    sourceFaces?: Uint32Array,
  ): CoreReport {
    const load = (positionsAt: number, trianglesAt: number, verticesAt: number, facesAt: number) =>
      this.#module._whittle_load(
        ...([this.#handle, positionsAt, positions.length / 3] as const),
        ...([
          trianglesAt,
          triangles.length / 3,
          sourceVertices ? verticesAt : 0,
          sourceFaces ? facesAt : 0,
        ] as const),
      );
    const none = new Uint32Array();
    const arrays = [positions, triangles, sourceVertices ?? none, sourceFaces ?? none];
    this.#check(this.#heap.withCopies(arrays, load));
    return this.#report();
  }

  configure(method: string, values: EncodedValues): void {
    this.#check(this.#heap.withString(method, (name) => this.#module._whittle_select(this.#handle, name)));
    const { parameters } = this.#methods.find(({ id }) => id === method)!;
    for (const { name } of parameters) this.#check(this.#set(name, values.get(name) ?? unset));
  }

  restart(): void {
    this.#module._whittle_restart(this.#handle);
  }

  prepareNext(): Preparation {
    const stage = this.#heap.readString(this.#module._whittle_stage(this.#handle));
    let code = 0;
    this.#heap.readNumbers(this.#share, (address) => {
      code = this.#module._whittle_prepare(this.#handle, address);
    });
    this.#check(code);
    return { stage, share: this.#share[0]! };
  }

  step(): Step {
    let code = 0;
    this.#heap.readNumbers(this.#stepNumbers, (address) => {
      code = this.#module._whittle_step(this.#handle, address);
    });
    this.#check(code);
    const outcome = this.#heap.readString(this.#module._whittle_outcome(this.#handle)) as Step['outcome'];
    return { outcome, energy: this.#stepNumbers[0]!, change: this.#stepNumbers[1]! };
  }

  copyPositions(into: Float64Array): void {
    this.#heap.readNumbers(into, (address) => this.#module._whittle_positions(this.#handle, address));
  }

  warnings(): string[] {
    const count = this.#module._whittle_warning_count(this.#handle);
    return Array.from({ length: count }, (_, index) =>
      this.#heap.readString(this.#module._whittle_warning(this.#handle, index)),
    );
  }

  fields(): readonly CoreField[] {
    return JSON.parse(this.#heap.readString(this.#module._whittle_fields(this.#handle)));
  }

  copyField(name: string, into: Float64Array): void {
    let code = 0;
    this.#heap.withString(name, (nameAt) =>
      this.#heap.readNumbers(into, (address) => {
        code = this.#module._whittle_field(this.#handle, nameAt, address);
      }),
    );
    this.#check(code);
  }

  free(): void {
    this.#module._whittle_destroy(this.#handle);
  }

  #set(parameter: string, { name, numbers, indices }: Encoded): number {
    const set = (numbersAt: number, indicesAt: number) =>
      this.#heap.withString(parameter, (parameterAt) =>
        this.#heap.withString(name, (nameAt) =>
          this.#module._whittle_set_value(
            ...([this.#handle, parameterAt, nameAt] as const),
            ...([numbersAt, numbers.length, indicesAt, indices.length] as const),
          ),
        ),
      );
    return this.#heap.withCopies([numbers, indices], set);
  }

  #report(): CoreReport {
    const numbers = new Float64Array(15);
    this.#heap.readNumbers(numbers, (address) => this.#module._whittle_report(this.#handle, address));
    const at = (index: number): number => numbers[index]!;
    return {
      vertices: at(0),
      faces: at(1),
      components: at(2),
      typicalPart: at(3),
      boundaryEdges: at(4),
      nonManifoldEdges: at(5),
      degenerateFaces: at(6),
      isolatedVertices: at(7),
      farVertices: at(8),
      min: [at(9), at(10), at(11)],
      max: [at(12), at(13), at(14)],
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
