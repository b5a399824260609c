import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Autosave } from '../../src/editor/autosave.ts';
import { KeptProjects, type KeptStorage } from '../../src/editor/kept-projects.ts';
import { shownPositions } from '../../src/editor/project.ts';
import { headlessEditor } from '../fixtures/headless-editor.ts';

/** Counts what is written, and refuses when told so. */
class Shelf implements KeptStorage {
  readonly values = new Map<string, unknown>();
  readonly written: string[] = [];
  isFull = false;

  async get(key: string) {
    return structuredClone(this.values.get(key));
  }
  async set(key: string, value: unknown) {
    if (this.isFull) throw new Error('full');
    this.written.push(key.split(' ')[0]!);
    this.values.set(key, structuredClone(value));
  }
  async delete(key: string) {
    this.values.delete(key);
  }
  async keys() {
    return [...this.values.keys()];
  }
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** An editor with a mesh in it, whose work is kept. */
async function desk(shelf = new Shelf(), id = 'one') {
  const { editor, store } = headlessEditor();
  const projects = new KeptProjects(shelf);
  const onTrouble = vi.fn();
  const autosave = new Autosave({ store, projects, id, link: '', onTrouble });
  const opened = editor.open(Uint8Array.of(1, 2), 'a.obj', { method: 'cubic', parameters: { lambda: 0.5 } });
  await vi.runAllTimersAsync();
  await opened;
  const set = (lambda: number) => editor.commit({ parameters: { lambda } }, 'Cubeness');
  const elapse = (milliseconds: number) => vi.advanceTimersByTimeAsync(milliseconds);
  return { editor, store, shelf, projects, autosave, onTrouble, set, elapse };
}

describe('autosave', () => {
  it('keeps the work a second after its last change, and nothing before there is any', async () => {
    const { autosave, shelf, projects, set, elapse } = await desk();
    await elapse(5000);
    expect([autosave.isUnsaved, shelf.values.size]).toEqual([false, 0]);
    set(1);
    expect(autosave.isUnsaved).toBe(true);
    await elapse(900);
    set(2);
    await elapse(900);
    expect(shelf.values.size).toBe(0);
    await elapse(200);
    expect(autosave.isUnsaved).toBe(false);
    const kept = (await projects.read('one'))!;
    expect(JSON.parse(kept.file.recipe!).steps).toEqual([{ method: 'cubic', lambda: 2 }]);
    expect(kept.file.mesh).toEqual({ name: 'a.obj', bytes: Uint8Array.of(1, 2) });
  });

  it('stores the mesh once and what is said of it each time; another mesh takes its place', async () => {
    const { editor, shelf, set, elapse } = await desk();
    for (const lambda of [1, 2, 3]) {
      set(lambda);
      await elapse(1100);
    }
    expect(shelf.written).toEqual(['bytes', 'project', 'project', 'project']);
    await editor.open(Uint8Array.of(9), 'b.obj');
    await elapse(1100);
    expect([...shelf.values.keys()].filter((key) => key.startsWith('bytes'))).toHaveLength(1);
    editor.undo();
    await elapse(1100);
    expect([...shelf.values.values()]).toContainEqual(Uint8Array.of(1, 2));
  });

  it('has nothing to keep where a change was taken back, and does not count results as changes', async () => {
    const { editor, autosave, shelf, set, elapse } = await desk();
    set(1);
    editor.undo();
    expect(autosave.isUnsaved).toBe(false);
    await elapse(3000);
    expect(shelf.values.size).toBe(0);
  });

  it('tells once that nothing can be kept, stays unsaved, and keeps it when there is room again', async () => {
    const { autosave, shelf, onTrouble, set, elapse } = await desk();
    shelf.isFull = true;
    for (const lambda of [1, 2]) {
      set(lambda);
      await elapse(1100);
    }
    expect(onTrouble).toHaveBeenCalledTimes(1);
    expect(autosave.isUnsaved).toBe(true);
    shelf.isFull = false;
    set(3);
    await elapse(1100);
    expect(autosave.isUnsaved).toBe(false);
  });

  it('asks nothing once the project is saved as a file', async () => {
    const { editor, autosave, shelf, set } = await desk();
    shelf.isFull = true;
    set(1);
    autosave.noteSaved(editor.project!);
    expect(autosave.isUnsaved).toBe(false);
    set(2);
    expect(autosave.isUnsaved).toBe(true);
  });

  it('lets go of all that was kept on a fresh start, which is no work; undo brings the work back', async () => {
    const { editor, autosave, shelf, set, elapse } = await desk();
    set(1);
    await elapse(1100);
    const shape = shownPositions(editor.project!);
    const fresh = autosave.startFresh(() => editor.open(Uint8Array.of(7), 'fresh.obj'));
    await elapse(3000);
    await fresh;
    expect([shelf.values.size, autosave.isUnsaved]).toEqual([0, false]);
    editor.undo();
    expect(shownPositions(editor.project!)).toBe(shape);
    await elapse(1100);
    expect(shelf.values.size).toBe(2);
  });
});

describe('kept projects', () => {
  it('of several windows stand beside each other', async () => {
    const shelf = new Shelf();
    const one = await desk(shelf, 'one');
    const two = await desk(shelf, 'two');
    one.set(1);
    await one.elapse(1100);
    two.set(2);
    await two.elapse(1100);
    one.set(3);
    await one.elapse(1100);
    expect(await one.projects.list()).toEqual(['one', 'two']);
    const recipes = await Promise.all(
      ['one', 'two'].map(async (id) => (await two.projects.read(id))!.file.recipe),
    );
    expect(recipes.map((text) => JSON.parse(text!).steps[0].lambda)).toEqual([3, 2]);
    await one.projects.remove('one');
    expect(await two.projects.read('two')).toBeDefined();
  });

  it('are none where some of their bytes are gone', async () => {
    const { shelf, projects, set, elapse } = await desk();
    set(1);
    await elapse(1100);
    for (const key of shelf.values.keys()) if (key.startsWith('bytes')) shelf.values.delete(key);
    expect(await projects.read('one')).toBeUndefined();
  });

  it('go, the oldest first, but for those of open windows', async () => {
    let now = 0;
    const shelf = new Shelf();
    const projects = new KeptProjects(shelf, () => ++now);
    const mesh = (k: number) => ({ name: 'a.obj', bytes: Uint8Array.of(k) });
    for (let k = 0; k < 7; k++)
      await projects.write(`w${k}`, { mesh: mesh(k), beside: new Map(), assets: new Map() }, '');
    await projects.trim(async (id) => id === 'w0');
    expect(await projects.list()).toEqual(['w6', 'w5', 'w4', 'w3', 'w0']);
    expect(shelf.values.size).toBe(10);
  });
});
