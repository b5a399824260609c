import { keptBytes } from './kept-bytes.ts';
import { type PackedProject, pack, unpack } from './packed-project.ts';
import type { Project } from './project.ts';

/** One gesture: what there was and what came of it. */
export interface Entry {
  readonly label: string;
  readonly before: Project;
  readonly after: Project;
}

/** A gesture long ago, or long undone: the project on its far side, packed against the one on its near side. */
interface FarEntry {
  readonly label: string;
  readonly far: PackedProject;
}

export interface History {
  /** The latest last. */
  readonly past: readonly Entry[];
  /** The next first. */
  readonly future: readonly Entry[];
  /** Before {@link past}, the latest last. */
  readonly farPast: readonly FarEntry[];
  /** After {@link future}, the next first. */
  readonly farFuture: readonly FarEntry[];
}

export const emptyHistory: History = Object.freeze({ past: [], future: [], farPast: [], farFuture: [] });

/** Most that undo may keep alive, in bytes. What is over is packed, the farthest from now first; what still is over goes. */
const budget = 256 * 2 ** 20;
const mostEntries = 200;
/** So many entries at both sides of now are kept as they are: undoing them gives back settled shapes. */
const nearEntries = 3;

/** Notes a finished gesture. What had been undone is gone. */
export function record(history: History, entry: Entry): History {
  return fitted({ ...history, past: [...history.past, entry], future: [], farFuture: [] });
}

/** The project before the latest gesture, or null when there is none. */
export function undo(history: History): { history: History; entry: Entry } | null {
  const { farPast, past, future, farFuture } = broughtNear(history);
  const entry = past.at(-1);
  if (!entry) return null;
  return {
    entry,
    history: fitted({ farPast, past: past.slice(0, -1), future: [entry, ...future], farFuture }),
  };
}

export function redo(history: History): { history: History; entry: Entry } | null {
  const { farPast, past, future, farFuture } = broughtNear(history);
  const [entry, ...others] = future;
  if (!entry) return null;
  return { entry, history: fitted({ farPast, past: [...past, entry], future: others, farFuture }) };
}

/** Puts a project's settled successor in its place wherever an entry holds it. */
export function amend(history: History, old: Project, now: Project): History {
  const put = (project: Project) => (project === old ? now : project);
  const each = (entry: Entry): Entry =>
    entry.before === old || entry.after === old
      ? { label: entry.label, before: put(entry.before), after: put(entry.after) }
      : entry;
  return { ...history, past: history.past.map(each), future: history.future.map(each) };
}

/** Unpacks what is next, so that there is an entry to undo and one to redo wherever there are any at all. */
function broughtNear(history: History): History {
  let { past, future, farPast, farFuture } = history;
  const [oldest] = past;
  const latest = future.at(-1);
  const farther = farPast.at(-1);
  if (past.length <= 1 && farther && oldest) {
    const before = unpack(farther.far, oldest.before);
    past = [{ label: farther.label, before, after: oldest.before }, ...past];
    farPast = farPast.slice(0, -1);
  }
  const [later] = farFuture;
  if (future.length <= 1 && later && latest) {
    const after = unpack(later.far, latest.after);
    future = [...future, { label: later.label, before: latest.after, after }];
    farFuture = farFuture.slice(1);
  }
  return { past, future, farPast, farFuture };
}

function fitted(history: History): History {
  let { past, future, farPast, farFuture } = history;
  const isOver = () => keptBytes(past, future, farPast, farFuture) > budget;
  while (past.length + farPast.length > mostEntries) {
    if (farPast.length > 0) farPast = farPast.slice(1);
    else past = past.slice(1);
  }
  while (isOver()) {
    if (past.length > nearEntries && past.length >= future.length) {
      const [oldest, ...others] = past;
      farPast = [...farPast, { label: oldest!.label, far: pack(oldest!.before, oldest!.after) }];
      past = others;
    } else if (future.length > nearEntries) {
      const last = future.at(-1)!;
      farFuture = [{ label: last.label, far: pack(last.after, last.before) }, ...farFuture];
      future = future.slice(0, -1);
    } else if (farPast.length > 0) farPast = farPast.slice(1);
    else if (farFuture.length > 0) farFuture = farFuture.slice(0, -1);
    else if (past.length > 1) past = past.slice(1);
    else break;
  }
  return { past, future, farPast, farFuture };
}
