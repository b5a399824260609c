import { describe, expect, test } from 'vitest';
import { selectedVertices } from '../../src/selection/index.ts';
import { Selecting, selectionSentence } from '../../web/app/selecting.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';
import { until } from '../fixtures/until.ts';

/** The fake engine reads a tetrahedron from any file. */
async function opened() {
  const parts = headlessEditor();
  const selecting = new Selecting(parts.store, parts.editor);
  await parts.editor.open(Uint8Array.of(1), 'a.obj');
  await quiet(parts.store);
  const selected = () => [...selectedVertices(selecting.selection!)];
  return { ...parts, selecting, selected };
}

describe('what is selected', () => {
  test('begins with nothing, and ends with its mesh', async () => {
    const { selecting, selected, editor } = await opened();
    expect(selected()).toEqual([]);
    selecting.combine([0, 2], 'replace');
    selecting.combine([3], 'add');
    expect(selected()).toEqual([0, 2, 3]);
    editor.commit({ parameters: { lambda: 2 } }, 'Cubeness');
    expect(selected()).toEqual([0, 2, 3]);
    await editor.open(Uint8Array.of(1), 'b.obj');
    expect(selected()).toEqual([]);
  });

  test('is inverted, grown and shrunk once the mesh has been looked at', async () => {
    const { selecting, selected } = await opened();
    selecting.combine([1], 'replace');
    selecting.invert();
    expect(selected()).toEqual([0, 2, 3]);
    selecting.want();
    await until(() => selecting.surface !== null);
    selecting.shrink();
    expect(selected()).toEqual([]);
    selecting.combine([1], 'replace');
    selecting.grow();
    expect(selected()).toEqual([0, 1, 2, 3]);
    expect(selecting.none()).toBe(true);
    expect(selecting.none()).toBe(false);
  });

  test('follows the angle from which on an edge bends, and the shape that rests', async () => {
    const { selecting, editor, store } = await opened();
    selecting.want();
    await until(() => selecting.surface !== null);
    const first = selecting.surface!;
    expect(first.patches.count).toBe(4);
    selecting.set({ angle: 175 });
    await until(() => selecting.surface !== first);
    expect(selecting.surface!.patches.count).toBe(1);
    const second = selecting.surface!;
    editor.commit({ parameters: { lambda: 2 } }, 'Cubeness');
    await quiet(store);
    await until(() => selecting.surface !== second);
    // The fake engine makes everything 1 + λ times as large.
    expect(selecting.surface!.places).toEqual(editor.project!.mesh.positions.map((x) => 3 * x));
  });

  test('is mirrored, and what has nothing opposite is counted', async () => {
    const { selecting, selected, store } = await opened();
    // The plane x = 0, in which all vertices but one lie.
    selecting.combine([2], 'replace');
    await selecting.mirror(0);
    expect(selected()).toEqual([2]);
    expect(store.state.select.remark).toBe('The mirror image is selected too.');
    selecting.combine([1, 2], 'replace');
    await selecting.mirror(0);
    expect(selected()).toEqual([1, 2]);
    expect(store.state.select.remark).toBe('The mirror image is selected too; 1 of 2 have nothing opposite.');
    selecting.combine([1], 'replace');
    await selecting.mirror(0);
    expect(store.state.select.remark).toBe('Nothing lies opposite: the mesh is not symmetric that way.');
  });

  test('is told in words', async () => {
    const { selecting } = await opened();
    const told = () => selectionSentence(selecting.selection!);
    expect(told()).toBe('Nothing is selected.');
    selecting.combine([1], 'add');
    expect(told()).toBe('1 of 4 vertices is selected.');
    selecting.combine([2], 'add');
    expect(told()).toBe('2 of 4 vertices are selected.');
    selecting.all();
    expect(told()).toBe('All 4 vertices are selected.');
  });
});

describe('groups', () => {
  test('keep what is selected by a name of its own, and give it back', async () => {
    const { selecting, selected, editor, store } = await opened();
    expect(selecting.name('ear')).toBeNull();
    selecting.combine([0, 1], 'replace');
    expect(selecting.name(' ear ')).toBe('ear');
    expect(selecting.name('ear')).toBe('ear 2');
    expect(selecting.name('  ')).toBe('Group');
    expect(editor.project!.groups.map(({ name }) => name)).toEqual(['ear', 'ear 2', 'Group']);
    selecting.combine([3], 'replace');
    selecting.take('ear', 'add');
    expect(selected()).toEqual([0, 1, 3]);
    selecting.take('ear', 'remove');
    expect(selected()).toEqual([3]);
    selecting.changeGroup('ear', 'add');
    expect(editor.project!.groups[0]).toEqual({ name: 'ear', vertices: [0, 1, 3] });
    selecting.changeGroup('ear', 'remove');
    selecting.rename('ear', 'foot');
    selecting.forget('Group');
    expect(editor.project!.groups).toEqual([
      { name: 'foot', vertices: [0, 1] },
      { name: 'ear 2', vertices: [0, 1] },
    ]);
    expect(store.state.history.past.at(-1)!.label).toBe('Forget “Group”');
    editor.undo();
    expect(editor.project!.groups).toHaveLength(3);
  });

  test('that lose their last vertex are gone', async () => {
    const { selecting, editor } = await opened();
    selecting.combine([2], 'replace');
    selecting.name('tip');
    selecting.changeGroup('tip', 'remove');
    expect(editor.project!.groups).toEqual([]);
  });
});
