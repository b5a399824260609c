import type { Encoded } from '../methods/values/parameter.ts';
import type { CoreParameter } from './core-api.ts';
import type { WasmHeap } from './wasm-heap.ts';
import type { WasmModule } from './wasm-module.ts';

const none: Encoded = { name: '', numbers: new Float64Array(), indices: new Uint32Array() };

/** How each kind of parameter crosses to a session of the core. */
export class WasmParameters {
  readonly #module: WasmModule;
  readonly #heap: WasmHeap;
  readonly #handle: number;

  /** @param handle the session's address */
  constructor(module: WasmModule, heap: WasmHeap, handle: number) {
    this.#module = module;
    this.#heap = heap;
    this.#handle = handle;
  }

  /** Sets one of the selected method, to its default where nothing is given. Answers the core's code, 0 if all is well. */
  set(parameter: CoreParameter, given: Encoded | undefined): number {
    const { kind, name, default: usual } = parameter;
    switch (kind) {
      case 'handles':
        return this.#setHandles(given ?? none);
      case 'scalars':
      case 'rotations':
        return this.#setScalars(name, (given ?? none).numbers);
      case 'vector':
      case 'rotation':
        return this.#setScalars(name, given?.numbers ?? Float64Array.from(usual as number[]));
      case 'style':
        return this.#setStyle(name, given ?? none);
      case 'textureSlopes':
        return this.#setRelief(name, given ?? none);
      case 'choice':
        return this.#setChoice(parameter, given);
      default:
        return this.#setNumber(name, given?.numbers[0] ?? Number(usual));
    }
  }

  #setChoice({ name, choices = [], default: usual, maxRows }: CoreParameter, given?: Encoded): number {
    const code = this.#setNumber(name, choices.indexOf(given?.name || String(usual)));
    return code !== 0 || !maxRows ? code : this.#setScalars(name, (given ?? none).numbers);
  }

  #setNumber(name: string, value: number): number {
    return this.#heap.withString(name, (address) =>
      this.#module._whittle_set_number(this.#handle, address, value),
    );
  }

  #setScalars(name: string, values: Float64Array): number {
    const set = (valuesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_scalars(this.#handle, nameAt, valuesAt, values.length),
      );
    return this.#heap.withCopies([values], set);
  }

  #setStyle(name: string, { name: form, numbers, indices }: Encoded): number {
    const kind = ['closest', 'vertex', 'face'].indexOf(form);
    const pointCount = indices[0] ?? 0;
    const points = numbers.subarray(0, 3 * pointCount);
    const normals = numbers.subarray(3 * pointCount);
    const triangles = indices.subarray(1);
    const set = (normalsAt: number, pointsAt: number, trianglesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_style(
          ...([this.#handle, nameAt, kind, normalsAt, normals.length / 3] as const),
          ...([pointsAt, pointCount, trianglesAt, triangles.length / 3] as const),
        ),
      );
    return this.#heap.withCopies([normals, points, triangles], set);
  }

  #setRelief(name: string, { numbers }: Encoded): number {
    const half = numbers.length / 2;
    const [uvs, slopes] = [numbers.subarray(0, half), numbers.subarray(half)].map((part) =>
      Float32Array.from(part),
    );
    const set = (uvsAt: number, slopesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_relief(this.#handle, nameAt, uvsAt, slopesAt, half / 6),
      );
    return this.#heap.withCopies([uvs!, slopes!], set);
  }

  #setHandles({ numbers, indices }: Encoded): number {
    const set = (verticesAt: number, targetsAt: number) =>
      this.#module._whittle_set_handles(this.#handle, verticesAt, targetsAt, indices.length);
    return this.#heap.withCopies([indices, numbers], set);
  }
}
