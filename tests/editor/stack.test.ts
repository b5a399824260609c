import { describe, expect, it } from 'vitest';
import { shownPositions } from '../../src/editor/project.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';

/** The fake engine makes everything 1 + λ times as large, so that a stack multiplies. */
const times = (factor: number) => tetrahedron().positions.map((x) => x * factor);

/** λ 0.5, 1 and 3, as three steps: 1.5, 2 and 4 times as large. */
async function three() {
  const parts = headlessEditor();
  const { editor, store, engine } = parts;
  const steps = [0.5, 1, 3].map((lambda) => ({ method: 'cubic', parameters: { lambda } }));
  await editor.open(Uint8Array.of(1), 'a.obj', { recipe: { steps } });
  const ids = editor.project!.steps.map(({ id }) => id);
  const solved = async () => {
    await quiet(store);
    return engine.calls.splice(0).filter((call) => call.startsWith('solve'));
  };
  await solved();
  const shown = () => [...shownPositions(editor.project!)];
  return { ...parts, ids: ids as [number, number, number], solved, shown };
}

describe('a stack of steps', () => {
  it('gives each step what the one before left', async () => {
    const { shown, canvas } = await three();
    expect(shown()).toEqual([...times(12)]);
    expect(canvas.last).toEqual(times(12));
  });

  it('solves only what a change made stale', async () => {
    const { editor, ids, solved, shown } = await three();
    editor.commit({ parameters: { lambda: 1 } }, 'Cubeness');
    expect(await solved()).toEqual(['solve rest 1']);
    expect(shown()).toEqual([...times(6)]);
    editor.activate(ids[1]);
    editor.commit({ parameters: { lambda: 0 } }, 'Cubeness');
    expect(await solved()).toEqual(['solve rest 0', 'solve rest 1']);
    expect(shown()).toEqual([...times(3)]);
  });

  it('leaves out what is switched off, and knows its result when it comes back', async () => {
    const { editor, ids, solved, shown } = await three();
    editor.switchStep(ids[1], false);
    expect(await solved()).toEqual(['solve rest 3']);
    expect(shown()).toEqual([...times(6)]);
    editor.switchStep(ids[1], true);
    expect(await solved()).toEqual(['solve rest 3']);
    editor.switchStep(ids[2], false);
    expect(await solved()).toEqual([]);
    expect(shown()).toEqual([...times(3)]);
    editor.switchStep(ids[2], true);
    expect(await solved()).toEqual([]);
    expect(shown()).toEqual([...times(12)]);
  });

  it('adds after the active step, moves and removes, each one entry that undo takes back without solving', async () => {
    const { editor, ids, solved, shown, store } = await three();
    editor.activate(ids[0]);
    await editor.addStep('cubic', { lambda: 9 });
    expect(await solved()).toEqual(['solve rest 9', 'solve rest 1', 'solve rest 3']);
    expect(editor.project!.steps.map(({ parameters }) => parameters.lambda)).toEqual([0.5, 9, 1, 3]);
    expect(editor.project!.active).toBe(editor.project!.steps[1]!.id);
    editor.moveStep(ids[2], 0);
    expect(await solved()).toEqual(['solve rest 3', 'solve rest 0.5', 'solve rest 9', 'solve rest 1']);
    editor.removeStep(editor.project!.active);
    await solved();
    expect(shown()).toEqual([...times(12)]);
    expect(store.state.history.past.map(({ label }) => label)).toEqual([
      'Add Cubic',
      'Move a step',
      'Remove a step',
    ]);
    while (editor.undo());
    expect(await solved()).toEqual([]);
    expect(editor.project!.steps.map(({ id }) => id)).toEqual(ids);
    expect(shown()).toEqual([...times(12)]);
  });

  it('shows the step that a gesture is in, and the whole when it has ended', async () => {
    const { editor, ids, solved, shown, store, canvas } = await three();
    editor.activate(ids[0]);
    editor.preview({ parameters: { lambda: 1 } });
    await quiet(store);
    expect(canvas.last).toEqual(times(2));
    editor.commit({ parameters: { lambda: 1 } }, 'Cubeness');
    expect(await solved()).toEqual(['solve current 1', 'solve rest 1', 'solve rest 1', 'solve rest 3']);
    expect(shown()).toEqual([...times(16)]);
    expect(canvas.last).toEqual(times(16));
  });

  it('is a recipe of the steps that are on, without what has its default', async () => {
    const { editor, ids } = await three();
    editor.switchStep(ids[1], false);
    await editor.addStep('polycube', { directions: 'octahedron' });
    expect(editor.recipe()!.steps.map(({ method }) => method)).toEqual(['cubic', 'cubic', 'polycube']);
    expect(editor.recipe()!.steps[2]!.parameters).toEqual({ directions: 'octahedron' });
  });

  it('keeps its last step', async () => {
    const { editor, ids } = await three();
    for (const id of ids) editor.removeStep(id);
    expect(editor.project!.steps).toHaveLength(1);
  });
});
