import type { WhittleDocument } from './project.ts';

/** One gesture: what there was and what came of it. */
export interface Entry {
  readonly label: string;
  readonly before: WhittleDocument;
  readonly after: WhittleDocument;
}

export interface History {
  readonly past: readonly Entry[];
  readonly future: readonly Entry[];
}

export const emptyHistory: History = Object.freeze({ past: [], future: [] });

/** Most that undo may hold on to, in bytes of results and sources; the oldest entries go first. */
const budget = 256 * 2 ** 20;
const mostEntries = 200;

/** Notes a finished gesture. What had been undone is gone. */
export function record(history: History, entry: Entry): History {
  let past = [...history.past, entry].slice(-mostEntries);
  while (past.length > 1 && bytesOf(past) > budget) past = past.slice(1);
  return { past, future: [] };
}

/** The document before the latest gesture, or null when there is none. */
export function undo(history: History): { history: History; entry: Entry } | null {
  const entry = history.past.at(-1);
  if (!entry) return null;
  return { entry, history: { past: history.past.slice(0, -1), future: [entry, ...history.future] } };
}

export function redo(history: History): { history: History; entry: Entry } | null {
  const [entry, ...future] = history.future;
  if (!entry) return null;
  return { entry, history: { past: [...history.past, entry], future } };
}

/** Puts a document's settled successor in its place wherever an entry holds it. */
export function amend(history: History, old: WhittleDocument, now: WhittleDocument): History {
  const put = (document: WhittleDocument) => (document === old ? now : document);
  const each = (entry: Entry): Entry =>
    entry.before === old || entry.after === old
      ? { label: entry.label, before: put(entry.before), after: put(entry.after) }
      : entry;
  return { past: history.past.map(each), future: history.future.map(each) };
}

function bytesOf(entries: readonly Entry[]): number {
  const buffers = new Set<ArrayBufferLike>();
  for (const { before, after } of entries)
    for (const { source, mesh, result } of [before, after]) {
      buffers.add(source.bytes.buffer).add(mesh.positions.buffer).add(mesh.triangles.buffer);
      if (mesh.uvs) buffers.add(mesh.uvs.buffer);
      if (result) buffers.add(result.positions.buffer);
    }
  let bytes = 0;
  for (const buffer of buffers) bytes += buffer.byteLength;
  return bytes;
}
