import type { Engine } from '../engine/client.ts';
import type { Format } from '../io/index.ts';
import { firstUnsettled, type Project, shownPositions } from './project.ts';
import { type EditorStore, idle, noticeOf } from './state.ts';
import { patiently, reportFailure, type Tasks } from './task.ts';

export interface Written {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly project: Project;
}

export interface WritingParts {
  readonly store: EditorStore;
  readonly engine: Engine;
  readonly tasks: Tasks;
}

/**
 * The file of a project in a format, with the settled shape. Null if it could not be written; a notice says why.
 *
 * @param again does it once more, where the worker died under it
 */
export async function writeProject(
  { store, engine, tasks }: WritingParts,
  project: Project,
  format: Format,
  again: () => void,
): Promise<Written | null> {
  if (firstUnsettled(project)) {
    const text =
      'Nothing was saved, as the shape was stopped or changed before it was finished; save it again.';
    if (store.state.notice?.tone !== 'error') store.set({ notice: { tone: 'note', text } });
    return null;
  }
  const { bytes, name, beside } = project.source;
  const task = tasks.begin();
  store.set({ activity: { kind: 'writing', name }, notice: null });
  try {
    const positions = shownPositions(project);
    const written = await patiently(task, () =>
      engine.write(bytes, name, format, positions, { signal: task.signal, beside }),
    );
    if (task.current()) store.set({ activity: idle, ...noticeOf(written.warnings) });
    return { bytes: written.bytes, project };
  } catch (thrown) {
    reportFailure(store, task, thrown, again);
    return null;
  }
}
