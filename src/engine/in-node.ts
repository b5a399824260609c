import { readFile } from 'node:fs/promises';
import { createEngine, type Engine } from './client.ts';
import { loadCore } from './core.ts';
import { fileServices } from './file-services.ts';
import { spawnInProcess } from './in-process.ts';

/** The wasm files lie at the same place from src/engine and from dist/engine. */
const wasmFile = new URL('../../wasm/dist/whittle-core.wasm', import.meta.url);
const dracoFile = new URL('../../wasm/dist/draco_decoder.wasm', import.meta.url);

/**
 * The engine in this very thread: it computes between turns of the event loop, so that Ctrl-C gets in between two steps.
 * `dispose()` it, or the process does not end.
 */
export function createNodeEngine(): Engine {
  const files = fileServices(() => readFile(dracoFile));
  const services = { ...files, loadCore: async () => loadCore(await readFile(wasmFile)) };
  return createEngine({ spawn: () => spawnInProcess(services) });
}
