import { Worker } from 'node:worker_threads';
import type { ClientPort } from '../../src/engine/port.ts';

/** The compiled server with the real core in a thread of its own, as a browser would run it in a worker. */
export function spawnThread(root: string): ClientPort & { crash(): void } {
  const url = (path: string) => JSON.stringify(new URL(path, `file://${root}/`).href);
  const script = `
    import { readFileSync } from 'node:fs';
    import { parentPort } from 'node:worker_threads';
    import { loadCore } from ${url('dist/engine/core.js')};
    import { fileServices } from ${url('dist/engine/file-services.js')};
    import { serve } from ${url('dist/engine/server.js')};
    const wasm = new URL(${url('wasm/dist/whittle-core.wasm')});
    serve(parentPort, { ...fileServices(), loadCore: () => loadCore(readFileSync(wasm)) });
    parentPort.addEventListener('message', ({ data }) => {
      if (data === 'crash') throw new Error('crashed on purpose');
    });`;
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(script)}`));
  const port: ReturnType<typeof spawnThread> = {
    onmessage: null,
    onerror: null,
    onmessageerror: null,
    postMessage: (message, transfer) => worker.postMessage(message, transfer),
    terminate: () => void worker.terminate(),
    crash: () => worker.postMessage('crash'),
  };
  worker.on('message', (data) => port.onmessage?.({ data } as MessageEvent));
  worker.on('error', ({ message }) => port.onerror?.({ message } as ErrorEvent));
  return port;
}
