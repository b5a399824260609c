import type { FromWorker, ToWorker } from './protocol.ts';

/** The worker's end of the line: a worker's global scope or a `MessagePort`, in browsers and in Node. */
export interface ServerPort {
  postMessage(message: FromWorker, transfer: ArrayBuffer[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
  close(): void;
}

/** The page's end of the line. A `Worker` is one as it stands. */
export interface ClientPort {
  postMessage(message: ToWorker, transfer: ArrayBuffer[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
  /** The worker's script could not be loaded, or something in it threw and nobody caught it. */
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
  terminate(): void;
}
