import { createEngine, type Engine } from '../../../src/engine/client.ts';

export function createBrowserEngine(): Engine {
  return createEngine({
    spawn: () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }),
  });
}
