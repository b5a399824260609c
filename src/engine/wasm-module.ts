/**
 * The module as Emscripten makes it. The C interface is documented in `wasm/bindings/whittle.h`; sessions, arrays and names
 * are addresses here.
 */
export interface WasmModule {
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

interface WasmOptions {
  readonly wasmBinary?: Uint8Array;
  readonly locateFile?: (name: string) => string;
}

type WasmFactory = (options: WasmOptions) => Promise<WasmModule>;

/**
 * Starts a module with memory of its own.
 *
 * @param wasm the module's bytes or their address; default: the file beside the loader
 */
export async function loadModule(wasm?: Uint8Array | string): Promise<WasmModule> {
  const { default: create }: { default: WasmFactory } = await import('../../wasm/dist/whittle-core.mjs');
  if (typeof wasm === 'string') return create({ locateFile: () => wasm });
  return create(wasm ? { wasmBinary: wasm } : {});
}
