export interface WorkerPlace {
  /** Where the worker's script lies. */
  readonly workerUrl: string | URL;
  /** Where the wasm file lies; default: where the worker's script expects it, beside itself. */
  readonly wasmUrl?: string | URL | undefined;
}

/**
 * Starts the worker's script from anywhere. Browsers only start scripts of the page's own origin; for another's, the page's own is one
 * line that imports it.
 */
export function startWorker({ workerUrl, wasmUrl }: WorkerPlace): Worker {
  const url = new URL(workerUrl, location.href);
  if (wasmUrl) url.searchParams.set('wasm', new URL(wasmUrl, location.href).href);
  if (url.origin === location.origin) return new Worker(url, { type: 'module' });
  const line = new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' });
  const address = URL.createObjectURL(line);
  const worker = new Worker(address, { type: 'module' });
  // The script is fetched by its first answer or its failure, whichever comes.
  const forget = () => URL.revokeObjectURL(address);
  worker.addEventListener('message', forget, { once: true });
  worker.addEventListener('error', forget, { once: true });
  return worker;
}
