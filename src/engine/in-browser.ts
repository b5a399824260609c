import { createEngine, type Engine } from './client.ts';

/** An engine in a web worker of its own. The worker starts at the first call, the wasm core at the first mesh. */
export function createBrowserEngine(options: BrowserEngineOptions = {}): Engine {
  return createEngine({
    spawn: () =>
      options.workerUrl === undefined
        ? // Bundlers look for exactly this expression.
          new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
        : new Worker(options.workerUrl, { type: 'module' }),
  });
}

export interface BrowserEngineOptions {
  /** Where the worker's script lies; default: beside this module. */
  readonly workerUrl?: string | URL;
}
