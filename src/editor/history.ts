import { keptBytes } from './kept-bytes.ts';
import type { Project } from './project.ts';

/** One gesture: what there was and what came of it. */
export interface Entry {
  readonly label: string;
  readonly before: Project;
  readonly after: Project;
}

export interface History {
  readonly past: readonly Entry[];
  readonly future: readonly Entry[];
}

export const emptyHistory: History = Object.freeze({ past: [], future: [] });

/** Most that undo may keep alive, in bytes; the oldest entries go first. */
const budget = 256 * 2 ** 20;
const mostEntries = 200;

/** Notes a finished gesture. What had been undone is gone. */
export function record(history: History, entry: Entry): History {
  let past = [...history.past, entry].slice(-mostEntries);
  while (past.length > 1 && keptBytes(past) > budget) past = past.slice(1);
  return { past, future: [] };
}

/** The project before the latest gesture, or null when there is none. */
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

/** Puts a project's settled successor in its place wherever an entry holds it. */
export function amend(history: History, old: Project, now: Project): History {
  const put = (project: Project) => (project === old ? now : project);
  const each = (entry: Entry): Entry =>
    entry.before === old || entry.after === old
      ? { label: entry.label, before: put(entry.before), after: put(entry.after) }
      : entry;
  return { past: history.past.map(each), future: history.future.map(each) };
}
