import { loadCore } from './core.ts';
import { fileServices } from './file-services.ts';
import type { ServerPort } from './port.ts';
import { serve } from './server.ts';

/** Where the wasm file lies, if whoever started this script said so: the query `wasm` of its address. */
const wasmUrl = new URL(import.meta.url).searchParams.get('wasm') ?? undefined;

async function readDraco(): Promise<Uint8Array> {
  const response = await fetch(new URL('../../wasm/dist/draco_decoder.wasm', import.meta.url));
  return new Uint8Array(await response.arrayBuffer());
}

/** The web worker's script. */
serve(globalThis as unknown as ServerPort, {
  ...fileServices(readDraco),
  loadCore: () => loadCore(wasmUrl),
});
