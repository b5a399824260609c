import { type FailureCode, WhittleError } from '../mesh/failure.ts';
import type { MeshReport } from '../mesh/mesh.ts';
import type { Handles, ParameterValues, Scalars } from '../methods/descriptor.ts';
import type { GaussMap } from '../methods/gauss-map.ts';
import type { Relief } from '../methods/relief.ts';
import type { Outcome } from './protocol.ts';

/** What one step of a session says. */
export interface Step {
  readonly outcome: 'running' | Exclude<Outcome, 'cancelled'>;
  /** Energy before the step, in the unit frame. */
  readonly energy: number;
  /** Relative displacement of the step (2019, §3.1). */
  readonly change: number;
}

/** One mesh in the core. Every call throws a {@link WhittleError} with the core's own code and element. */
export interface CoreSession {
  /** Validates and takes a welded mesh (#V×3, #F×3); forgets all that was there. */
  load(positions: Float64Array, triangles: Uint32Array): MeshReport;
  /** Chooses a method and its parameters (absent: default); handles, numbers and quaternions (x y z w) by vertex are those of
   *  welded vertices, a style is a Gauss map, a picture a relief. Keeps the current positions. */
  configure(method: string, parameters: ParameterValues): void;
  /** Goes back to the rest positions. */
  restart(): void;
  /** Computes what the parameters made stale and starts a run from the current positions. */
  prepare(): void;
  /** One iteration. */
  step(): Step;
  /** Writes the current positions, #V×3 in the file's units. */
  copyPositions(into: Float64Array): void;
  free(): void;
}

/** One parameter as the core lists it. */
export interface CoreParameter {
  readonly name: string;
  readonly kind: string;
  readonly invalidates: string;
  /** Of a choice, the name. */
  readonly default?: number | string | boolean | readonly number[];
  readonly min?: number;
  readonly max?: number;
  /** Names of a choice; it crosses to the core as the index of one. */
  readonly choices?: readonly string[];
  /** How many rows of a matrix it takes at most in place of a name. */
  readonly maxRows?: number;
}

export interface Core {
  open(): CoreSession;
  /** The core's own method list, which a contract test holds against the descriptors. */
  methods(): readonly { readonly id: string; readonly parameters: readonly CoreParameter[] }[];
  /** Bytes of the wasm heap. */
  heapBytes(): number;
}

/** The module as Emscripten makes it; the C interface is documented in `wasm/bindings/whittle.h`. */
interface WasmModule {
  /** Views change whenever memory grows: read them anew after every call. */
  readonly HEAPU8: Uint8Array<ArrayBuffer>;
  _malloc(bytes: number): number;
  _free(address: number): void;
  _whittle_create(): number;
  _whittle_destroy(session: number): void;
  _whittle_load(
    session: number,
    positions: number,
    vertices: number,
    triangles: number,
    faces: number,
  ): number;
  _whittle_report(session: number, numbers: number): void;
  _whittle_select(session: number, method: number): number;
  _whittle_set_number(session: number, parameter: number, value: number): number;
  _whittle_set_scalars(session: number, parameter: number, values: number, count: number): number;
  _whittle_set_style(
    session: number,
    parameter: number,
    kind: number,
    normals: number,
    normalCount: number,
    points: number,
    pointCount: number,
    triangles: number,
    triangleCount: number,
  ): number;
  _whittle_set_relief(session: number, parameter: number, uvs: number, slopes: number, faces: number): number;
  _whittle_set_handles(session: number, vertices: number, targets: number, count: number): number;
  _whittle_restart(session: number): void;
  _whittle_prepare(session: number): number;
  _whittle_step(session: number, outcome: number): number;
  _whittle_positions(session: number, positions: number): void;
  _whittle_code_name(code: number): number;
  _whittle_message(session: number): number;
  _whittle_element(session: number): number;
  _whittle_methods(): number;
}

type WasmFactory = (options: { wasmBinary?: Uint8Array }) => Promise<WasmModule>;

const outcomes = ['running', 'converged', 'iteration-limit', 'stalled'] as const;

/**
 * Starts the core.
 *
 * @param wasmBinary the module's bytes, where the loader cannot fetch them itself (Node)
 */
export async function loadCore(wasmBinary?: Uint8Array): Promise<Core> {
  const { default: create }: { default: WasmFactory } = await import('../../wasm/dist/whittle-core.mjs');
  const module = await create(wasmBinary ? { wasmBinary } : {});
  const heap = new Heap(module);
  return {
    open: () => new WasmSession(module, heap),
    methods: () => JSON.parse(heap.readString(module._whittle_methods())),
    heapBytes: () => module.HEAPU8.byteLength,
  };
}

/** The only hands on wasm memory: claim, copy in, call, look again, copy out, release. */
class Heap {
  readonly #module: WasmModule;

  constructor(module: WasmModule) {
    this.#module = module;
  }

  /** Runs `use` with the addresses of copies of the given arrays and frees them afterwards. */
  withCopies<Result>(arrays: readonly ArrayBufferView[], use: (...addresses: number[]) => Result): Result {
    const addresses: number[] = [];
    try {
      for (const array of arrays) {
        const address = this.#claim(array.byteLength);
        addresses.push(address);
        this.#module.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), address);
      }
      return use(...addresses);
    } finally {
      for (const address of addresses) this.#module._free(address);
    }
  }

  /** Lets `write` fill `into.length` numbers at an address and copies them out. */
  readNumbers(into: Float64Array, write: (address: number) => void): void {
    const address = this.#claim(into.byteLength);
    try {
      write(address);
      into.set(new Float64Array(this.#module.HEAPU8.buffer, address, into.length));
    } finally {
      this.#module._free(address);
    }
  }

  readString(address: number): string {
    const bytes = this.#module.HEAPU8;
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  #claim(bytes: number): number {
    const address = this.#module._malloc(Math.max(bytes, 8));
    if (address === 0)
      throw new WhittleError('out-of-memory', 'There is not enough memory for this mesh; try a smaller one.');
    return address;
  }
}

class WasmSession implements CoreSession {
  readonly #module: WasmModule;
  readonly #heap: Heap;
  readonly #handle: number;
  readonly #stepNumbers = new Float64Array(3);

  constructor(module: WasmModule, heap: Heap) {
    this.#module = module;
    this.#heap = heap;
    this.#handle = module._whittle_create();
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

  configure(method: string, parameters: ParameterValues): void {
    this.#check(this.#withString(method, (name) => this.#module._whittle_select(this.#handle, name)));
    const info = this.#methods().find((candidate) => candidate.id === method)!;
    for (const parameter of info.parameters) {
      const given = parameters[parameter.name];
      if (parameter.kind === 'handles') {
        this.#setHandles(given as Handles | undefined);
      } else if (parameter.kind === 'scalars' || parameter.kind === 'rotations') {
        this.#setScalars(parameter.name, given as Scalars | undefined);
      } else if (parameter.kind === 'vector' || parameter.kind === 'rotation') {
        this.#setScalars(parameter.name, (given ?? parameter.default) as Scalars);
      } else if (parameter.kind === 'style') {
        this.#setStyle(parameter.name, given as GaussMap | undefined);
      } else if (parameter.kind === 'relief') {
        this.#setRelief(parameter.name, given as Relief | undefined);
      } else {
        const isMatrix = Array.isArray(given);
        const value = (isMatrix ? undefined : given) ?? parameter.default;
        const index = parameter.choices?.indexOf(String(value)); // -1 is outside the range: the core refuses it
        this.#setNumber(parameter.name, index ?? Number(value));
        if (parameter.maxRows) this.#setScalars(parameter.name, isMatrix ? (given.flat() as number[]) : []);
      }
    }
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

  #methods(): ReturnType<Core['methods']> {
    return JSON.parse(this.#heap.readString(this.#module._whittle_methods()));
  }

  #setNumber(name: string, value: number): void {
    this.#check(
      this.#withString(name, (address) => this.#module._whittle_set_number(this.#handle, address, value)),
    );
  }

  #setScalars(name: string, given: Scalars = []): void {
    const values = Float64Array.from(given);
    const set = (valuesAt: number) =>
      this.#withString(name, (nameAt) =>
        this.#module._whittle_set_scalars(this.#handle, nameAt, valuesAt, values.length),
      );
    this.#check(this.#heap.withCopies([values], set));
  }

  #setStyle(name: string, style?: GaussMap): void {
    const { normals, points, triangles, kind } = flatStyle(style);
    const set = (normalsAt: number, pointsAt: number, trianglesAt: number) =>
      this.#withString(name, (nameAt) =>
        this.#module._whittle_set_style(
          ...([this.#handle, nameAt, kind, normalsAt, normals.length / 3] as const),
          ...([pointsAt, points.length / 3, trianglesAt, triangles.length / 3] as const),
        ),
      );
    this.#check(this.#heap.withCopies([normals, points, triangles], set));
  }

  #setRelief(name: string, relief: Relief = noRelief): void {
    const { uvs, slopes } = relief;
    const set = (uvsAt: number, slopesAt: number) =>
      this.#withString(name, (nameAt) =>
        this.#module._whittle_set_relief(this.#handle, nameAt, uvsAt, slopesAt, uvs.length / 6),
      );
    this.#check(this.#heap.withCopies([uvs, slopes], set));
  }

  #setHandles(handles: Handles = { vertices: [], targets: [] }): void {
    const vertices = Int32Array.from(handles.vertices);
    const targets = Float64Array.from(handles.targets.flat());
    const set = (verticesAt: number, targetsAt: number) =>
      this.#module._whittle_set_handles(this.#handle, verticesAt, targetsAt, vertices.length);
    this.#check(this.#heap.withCopies([vertices, targets], set));
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

  #withString<Result>(text: string, use: (address: number) => Result): Result {
    return this.#heap.withCopies([new TextEncoder().encode(`${text}\0`)], use);
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

const noRelief: Relief = { uvs: new Float32Array(), slopes: new Float32Array() };

/** A style as the C interface takes it: kind 0, 1, 2, or -1 for none. */
function flatStyle(style?: GaussMap) {
  const points = style?.kind === 'sphere' ? style.points : new Float64Array();
  const triangles = style?.kind === 'sphere' ? style.triangles : new Uint32Array();
  const normals = style?.normals ?? new Float64Array();
  if (!style) return { kind: -1, normals, points, triangles };
  const kind = style.kind === 'closest' ? 0 : style.per === 'vertex' ? 1 : 2;
  return { kind, normals, points, triangles };
}
