import { WhittleError } from '../mesh/failure.ts';

/**
 * The module as Emscripten makes it. The C interface is documented in `wasm/bindings/whittle.h`; sessions, arrays and names
 * are addresses here.
 */
export interface WasmModule {
  /** Views change whenever memory grows: read them anew after every call. */
  readonly HEAPU8: Uint8Array<ArrayBuffer>;
  _malloc(bytes: number): number;
  _free(address: number): void;
  _whittle_abi_version(): number;
  _whittle_create(): number;
  _whittle_destroy(session: number): void;
  _whittle_load(
    session: number,
    positions: number,
    vertices: number,
    triangles: number,
    faces: number,
    sourceVertices: number,
    sourceFaces: number,
  ): number;
  _whittle_report(session: number, numbers: number): void;
  _whittle_select(session: number, method: number): number;
  _whittle_set_value(
    session: number,
    parameter: number,
    name: number,
    numbers: number,
    numberCount: number,
    indices: number,
    indexCount: number,
  ): number;
  _whittle_restart(session: number): void;
  _whittle_prepare(session: number, share: number): number;
  _whittle_stage(session: number): number;
  _whittle_step(session: number, energyAndChange: number): number;
  _whittle_outcome(session: number): number;
  _whittle_positions(session: number, positions: number): void;
  _whittle_warning_count(session: number): number;
  _whittle_warning(session: number, index: number): number;
  _whittle_fields(session: number): number;
  _whittle_field(session: number, name: number, values: number): number;
  _whittle_code_name(code: number): number;
  _whittle_message(session: number): number;
  _whittle_element(session: number): number;
  _whittle_methods(): number;
}

interface WasmOptions {
  readonly wasmBinary?: Uint8Array;
  readonly locateFile?: (name: string) => string;
}

/** The version of the C interface that these declarations are of; `wasm/bindings/whittle.h` has it too. */
const abiVersion = 4;

type WasmFactory = (options: WasmOptions) => Promise<WasmModule>;

/**
 * Starts a module with memory of its own.
 *
 * @param wasm the module's bytes or their address; default: the file beside the loader
 * @throws WhittleError `internal` where the file's C interface is another
 */
export async function loadModule(wasm?: Uint8Array | string): Promise<WasmModule> {
  const { default: create }: { default: WasmFactory } = await import('../../wasm/dist/whittle-core.mjs');
  const module = await create(
    typeof wasm === 'string' ? { locateFile: () => wasm } : wasm ? { wasmBinary: wasm } : {},
  );
  requireVersion(module);
  return module;
}

/** @throws WhittleError `internal` where the module's C interface is not the one that is declared here */
export function requireVersion(module: Partial<Pick<WasmModule, '_whittle_abi_version'>>): void {
  const version = module._whittle_abi_version?.() ?? 1; // the first version did not say
  if (version === abiVersion) return;
  throw new WhittleError(
    'internal',
    `The wasm file is of another version than the program (${version}, not ${abiVersion}). Reload the page, or build both again.`,
  );
}
