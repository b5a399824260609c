import { describe, expect, it } from 'vitest';
import { activeStep, shownPositions } from '../../src/editor/project.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';
import { until } from '../fixtures/until.ts';

/** One thing begins while another is under way. The fake engine makes everything 1 + λ times as large. */
const times = (factor: number) => tetrahedron().positions.map((x) => x * factor);
const bytes = Uint8Array.of(1);

/** λ 0.5, 1 and 3, as three steps of a slow engine; the last is edited. */
async function three() {
  const parts = headlessEditor({ pause: () => new Promise((go) => setTimeout(go, 1)) });
  const { editor, store } = parts;
  const steps = [0.5, 1, 3].map((lambda) => ({ method: 'cubic', parameters: { lambda } }));
  await editor.open(bytes, 'a.obj', { recipe: { steps } });
  const ids = editor.project!.steps.map(({ id }) => id) as [number, number, number];
  const solves = (id: number) =>
    until(() => store.state.activity.kind === 'solving' && store.state.activity.step === id);
  const lambda = (value: number) => ({
    parameters: { ...activeStep(editor.project!).parameters, lambda: value },
  });
  parts.engine.calls.length = 0;
  return { ...parts, ids, solves, lambda };
}

describe('while steps are solved', () => {
  it('a stop in the second keeps what the second has, and calls nothing of before a result of it', async () => {
    const { editor, store, ids, solves, lambda, canvas } = await three();
    editor.activate(ids[0]);
    editor.commit(lambda(1), 'Cubeness');
    await solves(ids[1]);
    editor.cancel();
    await quiet(store);
    const [first, second, third] = editor.project!.steps.map(({ result }) => result!);
    expect(second!.state).toBe('stopped');
    expect(second!.of.from).toBe(first!.positions);
    const grown = second!.positions[3]! / first!.positions[3]!;
    expect(grown).toBeGreaterThanOrEqual(1);
    expect(grown).toBeLessThanOrEqual(2);
    expect(third!.of.from).not.toBe(second!.positions);
    expect(canvas.last).toEqual(second!.positions);
  });

  it('a step that is taken out meanwhile is solved no longer', async () => {
    const { editor, store, engine, ids, solves, lambda } = await three();
    editor.activate(ids[0]);
    editor.commit(lambda(1), 'Cubeness');
    await solves(ids[1]);
    const stops = engine.stops;
    editor.removeStep(ids[1]);
    await quiet(store);
    expect(engine.stops).toBe(stops + 1);
    expect(shownPositions(editor.project!)).toEqual(times(8));
  });

  it('a file that turns out broken leaves the stack to be solved to its end', async () => {
    const { editor, store, ids, solves, lambda, canvas } = await three();
    editor.activate(ids[0]);
    editor.commit(lambda(1), 'Cubeness');
    await solves(ids[1]);
    await editor.open(bytes, 'broken.obj');
    expect(store.state.notice!.text).toContain('broken.obj');
    expect(canvas.last).toEqual(times(16));
  });

  it('an editor that is disposed of shows nothing more and leaves nothing in the worker', async () => {
    const { editor, store, engine, ids, solves, lambda, canvas } = await three();
    editor.activate(ids[0]);
    editor.commit(lambda(1), 'Cubeness');
    await solves(ids[1]);
    const shown = canvas.last;
    editor.dispose();
    store.set({ project: null, activity: { kind: 'idle' } });
    await quiet(store);
    expect(canvas.last).toBe(shown);
    expect(engine.held.size).toBe(0);
    expect(store.state.notice).toBeNull();
  });
});

describe('two openings at once', () => {
  it('end with the later file, and the worker has the mesh of no other', async () => {
    const { editor, engine, store } = await three();
    await Promise.all([editor.open(bytes, 'b.obj'), editor.open(bytes, 'c.obj')]);
    await quiet(store);
    expect(editor.project!.source.name).toBe('c.obj');
    expect([...engine.held]).toEqual([editor.project!.mesh]);
    expect(store.state.history.past).toHaveLength(1);
  });
});

describe('a gesture', () => {
  it('back to a value whose result is known comes to rest, with that result on the screen', async () => {
    const { editor, store, lambda, canvas } = await three();
    editor.preview(lambda(3));
    await quiet(store);
    expect(canvas.last).toEqual(times(12));
  });

  it('that something else ends is an entry of its own', async () => {
    const { editor, store, ids, lambda } = await three();
    editor.preview(lambda(1));
    editor.activate(ids[0]);
    editor.preview(lambda(1));
    editor.switchStep(ids[1], false);
    await quiet(store);
    expect(store.state.history.past.map(({ label }) => label)).toEqual([
      'Cubic',
      'Cubic',
      'Switch a step off',
    ]);
    expect(shownPositions(editor.project!)).toEqual(times(4));
  });

  it('is what undo takes back first', async () => {
    const { editor, store, lambda, canvas } = await three();
    editor.commit(lambda(1), 'Cubeness');
    await quiet(store);
    editor.preview(lambda(0));
    editor.undo();
    await quiet(store);
    expect(canvas.last).toEqual(times(6));
    expect(store.state.history.past).toHaveLength(1);
  });

  it('during an export goes into the file, or a sentence says that there is none', async () => {
    const { editor, store, lambda } = await three();
    editor.preview(lambda(1));
    const written = await editor.write('obj');
    expect(shownPositions(written!.project)).toEqual(times(6));
    editor.preview(lambda(0));
    let isOver = false;
    const later = editor.write('obj').finally(() => {
      isOver = true;
    });
    for (let value = 0.25; !isOver; value += 0.25) {
      editor.preview(lambda(value));
      await new Promise((resolve) => setTimeout(resolve, 0));
    }
    expect(await later).toBeNull();
    expect(store.state.notice!.text).toContain('save it again');
  });
});

describe('a choice that takes its time', () => {
  it('yields to a later one, even to the method that is there already', async () => {
    const { editor, store } = await three();
    void editor.chooseMethod('analogy');
    void editor.chooseMethod('cubic');
    await quiet(store);
    expect(activeStep(editor.project!).method).toBe('cubic');
  });

  it('is not put on another step that was gone into meanwhile', async () => {
    const { editor, store, ids } = await three();
    void editor.chooseMethod('analogy');
    editor.activate(ids[0]);
    await quiet(store);
    expect(editor.project!.steps.map(({ method }) => method)).toEqual(['cubic', 'cubic', 'cubic']);
  });

  it('does not stop the run of a later value that had less to read', async () => {
    const { editor, store, lambda } = await three();
    await editor.chooseMethod('analogy');
    editor.preview(lambda(0.125));
    editor.commit(lambda(0.25), 'Strength');
    await editor.chooseMethod('cubic');
    await quiet(store);
    expect(editor.project!.steps.map(({ result }) => result!.state)).toEqual(Array(3).fill('settled'));
  });
});
