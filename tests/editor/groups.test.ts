import { describe, expect, test } from 'vitest';
import { freeGroupName, renamedGroup, withGroup, withoutGroup } from '../../src/editor/groups.ts';
import { formatRecipe, parseRecipe } from '../../src/recipe/index.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';

const ear = { name: 'ear', vertices: [0, 1] };
const foot = { name: 'foot', vertices: [2] };

async function opened(recipe = parseRecipe('{"whittle": 1, "steps": [{"method": "cubic"}]}', 'r.json')) {
  const parts = headlessEditor();
  await parts.editor.open(Uint8Array.of(1), 'a.obj', { recipe });
  await quiet(parts.store);
  return parts;
}

describe('lists of groups', () => {
  test('have each name once', () => {
    expect(withGroup([ear, foot], { name: 'ear', vertices: [3] })).toEqual([
      { name: 'ear', vertices: [3] },
      foot,
    ]);
    expect(withGroup([ear], foot)).toEqual([ear, foot]);
    expect(withoutGroup([ear, foot], 'ear')).toEqual([foot]);
    expect(freeGroupName([ear, foot], 'ear')).toBe('ear 2');
    expect(freeGroupName([ear, { name: 'ear 2', vertices: [] }], 'ear')).toBe('ear 3');
    expect(freeGroupName([ear], 'nose')).toBe('nose');
  });

  test('are renamed in place', () => {
    expect(renamedGroup([ear, foot], 'ear', ' left ear ')).toEqual([{ ...ear, name: 'left ear' }, foot]);
    expect(renamedGroup([ear, foot], 'ear', 'foot')).toEqual([{ ...ear, name: 'foot 2' }, foot]);
    const same = [ear, foot];
    for (const [from, to] of [['ear', 'ear'], ['ear', '  '], ['nose', 'x']] as const) // biome-ignore format: pairs
      expect(renamedGroup(same, from, to)).toBe(same);
  });
});

describe('a project’s groups', () => {
  test('come and go as entries of undo, and nothing is solved for them', async () => {
    const { editor, store, engine } = await opened();
    engine.calls.length = 0;
    editor.changeGroups((groups) => withGroup(groups, ear), 'Name “ear”');
    editor.changeGroups((groups) => withGroup(groups, foot), 'Name “foot”');
    editor.changeGroups((groups) => groups, 'Nothing');
    await quiet(store);
    expect(store.state.history.past.map(({ label }) => label)).toEqual(['Name “ear”', 'Name “foot”']);
    expect(editor.undo()).toBe(true);
    expect(editor.project!.groups).toEqual([ear]);
    editor.undo();
    expect(editor.project!.groups).toEqual([]);
    editor.redo();
    expect(editor.project!.groups).toEqual([ear]);
    expect(engine.calls).toEqual([]);
  });

  test('are saved and opened with the recipe', async () => {
    const { editor } = await opened();
    editor.changeGroups(() => [ear, foot], 'Name');
    const text = formatRecipe(editor.recipe()!);
    const again = await opened(parseRecipe(text, 'r.json'));
    expect(again.editor.project!.groups).toEqual([ear, foot]);
    expect(formatRecipe(again.editor.recipe()!)).toBe(text);
  });

  test('of vertices that the mesh has not are refused, and the mesh that was there stays', async () => {
    const { editor, store } = await opened();
    const before = editor.project;
    const stranger = { name: 'nose', vertices: [4] };
    expect(() => editor.changeGroups((groups) => [...groups, stranger], 'Name')).toThrow('has 4 vertices');
    expect(editor.project).toBe(before);
    const recipe = { steps: [{ method: 'cubic', parameters: {} }], groups: [stranger] };
    await editor.open(Uint8Array.of(1), 'b.obj', { recipe });
    expect(store.state.notice).toMatchObject({ tone: 'error', code: 'bad-recipe' });
    expect(editor.project).toBe(before);
  });
});
