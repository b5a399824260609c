import { createEngine, type Engine } from '../engine/client.ts';
import { startWorker, type WorkerPlace } from '../engine/start-worker.ts';

/** One engine, hence one worker, for all elements of a page that name the same files. */
interface Shared {
  readonly engine: Engine;
  users: number;
}

const shared = new Map<string, Shared>();

/** The engine of a place; every call is to be answered by one of {@link releaseEngine}. */
export function takeEngine(place: WorkerPlace): Engine {
  const key = keyOf(place);
  const known = shared.get(key) ?? { engine: createEngine({ spawn: () => startWorker(place) }), users: 0 };
  known.users++;
  shared.set(key, known);
  return known.engine;
}

/** Ends the worker when nobody uses it any more. */
export function releaseEngine(place: WorkerPlace): void {
  const key = keyOf(place);
  const known = shared.get(key);
  if (!known || --known.users > 0) return;
  shared.delete(key);
  known.engine.dispose();
}

function keyOf({ workerUrl, wasmUrl = '' }: WorkerPlace): string {
  return `${workerUrl} ${wasmUrl}`;
}
