import type { Handles, ParameterValue, Scalars } from '../methods/descriptor.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { Relief } from '../methods/values/texture-slopes.ts';
import type { CoreParameter } from './core-api.ts';
import type { WasmHeap } from './wasm-heap.ts';
import type { WasmModule } from './wasm-module.ts';

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
  set(parameter: CoreParameter, given: ParameterValue | undefined): number {
    switch (parameter.kind) {
      case 'handles':
        return this.#setHandles(given as Handles | undefined);
      case 'scalars':
      case 'rotations':
        return this.#setScalars(parameter.name, given as Scalars | undefined);
      case 'vector':
      case 'rotation':
        return this.#setScalars(parameter.name, (given ?? parameter.default) as Scalars);
      case 'style':
        return this.#setStyle(parameter.name, given as GaussMap | undefined);
      case 'relief':
        return this.#setRelief(parameter.name, given as Relief | undefined);
      default:
        return this.#setValue(parameter, given);
    }
  }

  /** A number, a flag or a choice, in whose place a matrix may be given. */
  #setValue(parameter: CoreParameter, given: ParameterValue | undefined): number {
    const isMatrix = Array.isArray(given);
    const value = (isMatrix ? undefined : given) ?? parameter.default;
    const index = parameter.choices?.indexOf(String(value)); // -1 is outside the range: the core refuses it
    const code = this.#setNumber(parameter.name, index ?? Number(value));
    if (code !== 0 || !parameter.maxRows) return code;
    return this.#setScalars(parameter.name, isMatrix ? (given.flat() as number[]) : []);
  }

  #setNumber(name: string, value: number): number {
    return this.#heap.withString(name, (address) =>
      this.#module._whittle_set_number(this.#handle, address, value),
    );
  }

  #setScalars(name: string, given: Scalars = []): number {
    const values = Float64Array.from(given);
    const set = (valuesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_scalars(this.#handle, nameAt, valuesAt, values.length),
      );
    return this.#heap.withCopies([values], set);
  }

  #setStyle(name: string, style?: GaussMap): number {
    const { normals, points, triangles, kind } = flatStyle(style);
    const set = (normalsAt: number, pointsAt: number, trianglesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_style(
          ...([this.#handle, nameAt, kind, normalsAt, normals.length / 3] as const),
          ...([pointsAt, points.length / 3, trianglesAt, triangles.length / 3] as const),
        ),
      );
    return this.#heap.withCopies([normals, points, triangles], set);
  }

  #setRelief(name: string, relief: Relief = noRelief): number {
    const { uvs, slopes } = relief;
    const set = (uvsAt: number, slopesAt: number) =>
      this.#heap.withString(name, (nameAt) =>
        this.#module._whittle_set_relief(this.#handle, nameAt, uvsAt, slopesAt, uvs.length / 6),
      );
    return this.#heap.withCopies([uvs, slopes], set);
  }

  #setHandles(handles: Handles = { vertices: [], targets: [] }): number {
    const vertices = Int32Array.from(handles.vertices);
    const targets = Float64Array.from(handles.targets.flat());
    const set = (verticesAt: number, targetsAt: number) =>
      this.#module._whittle_set_handles(this.#handle, verticesAt, targetsAt, vertices.length);
    return this.#heap.withCopies([vertices, targets], set);
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
