import { createEngine, type Engine } from './client.ts';
import { startWorker, type WorkerPlace } from './start-worker.ts';

/** An engine in a web worker of its own. The worker starts at the first call, the wasm core at the first mesh. */
export function createBrowserEngine({ workerUrl, wasmUrl }: BrowserEngineOptions = {}): Engine {
  return createEngine({
    spawn: () =>
      workerUrl === undefined
        ? // Bundlers look for exactly this expression.
          new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })
        : startWorker({ workerUrl, wasmUrl }),
  });
}

/** Default: the worker's script beside this module, and the wasm file beside that. */
export type BrowserEngineOptions = Partial<WorkerPlace>;
