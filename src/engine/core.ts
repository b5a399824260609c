import type { Core } from './core-api.ts';
import { WasmHeap } from './wasm-heap.ts';
import { loadModule } from './wasm-module.ts';
import { WasmSession } from './wasm-session.ts';

/**
 * Starts the core.
 *
 * @param wasm the module's bytes, where the loader cannot fetch them itself (Node), or their address, where it is not beside the loader
 */
export async function loadCore(wasm?: Uint8Array | string): Promise<Core> {
  const module = await loadModule(wasm);
  const heap = new WasmHeap(module);
  const methods: Core['methods'] = () => JSON.parse(heap.readString(module._whittle_methods()));
  return {
    open: () => new WasmSession(module, heap, methods),
    methods,
    heapBytes: () => heap.bytes,
  };
}
