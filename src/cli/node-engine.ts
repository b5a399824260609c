import { readFile } from 'node:fs/promises';
import { createEngine, type Engine } from '../engine/client.ts';
import { loadCore } from '../engine/core.ts';
import { fileServices } from '../engine/file-services.ts';
import { spawnInProcess } from '../engine/in-process.ts';

/** The same place from src/cli and from dist/cli. */
const wasmFile = new URL('../../wasm/dist/whittle-core.wasm', import.meta.url);

/**
 * The engine in this very thread: it computes between turns of the event loop, so that Ctrl-C gets in between two steps.
 * `dispose()` it, or the process does not end.
 */
export function createNodeEngine(): Engine {
  const services = { ...fileServices, loadCore: async () => loadCore(await readFile(wasmFile)) };
  return createEngine({ spawn: () => spawnInProcess(services) });
}
