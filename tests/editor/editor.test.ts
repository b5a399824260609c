import { describe, expect, it } from 'vitest';
import { activeStep } from '../../src/editor/project.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { headlessEditor, look, quiet } from '../fixtures/headless-editor.ts';
import { until } from '../fixtures/until.ts';

const bytes = Uint8Array.of(1);

function desk(...options: Parameters<typeof headlessEditor>) {
  const parts = headlessEditor(...options);
  const { editor } = parts;
  const lambda = (value: number) => ({
    parameters: { ...activeStep(editor.project!).parameters, lambda: value },
  });
  return { ...parts, lambda };
}

const expected = (lambda: number) => tetrahedron().positions.map((x) => x * (1 + lambda));
const aTurn = () => new Promise((resolve) => setTimeout(resolve, 0));

describe('opening', () => {
  it('carves from rest, with frames, to a settled result', async () => {
    const { engine, editor, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    const { parameters, result } = look(editor.project);
    expect(engine.calls).toEqual(['read', 'inspect', `solve rest ${parameters.lambda}`]);
    expect(result!.state).toBe('settled');
    expect(canvas.last).toEqual(expected(parameters.lambda as number));
  });

  it('keeps the mesh that was there when the file is broken', async () => {
    const { editor, store } = desk();
    await editor.open(bytes, 'a.obj');
    const before = editor.project;
    await editor.open(bytes, 'broken.obj');
    expect(editor.project).toBe(before);
    expect(store.state.notice).toMatchObject({ tone: 'error', text: 'broken.obj, line 3: not a number.' });
  });

  it('can be undone', async () => {
    const { editor, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    await editor.open(bytes, 'b.obj');
    expect(editor.undo()).toBe(true);
    expect(editor.project!.source.name).toBe('a.obj');
    expect(canvas.shown).toBe(3);
  });

  it('takes a method with values of one’s own, or a whole recipe', async () => {
    const { editor } = desk();
    await editor.open(bytes, 'a.obj', { method: 'analogy', parameters: { style: 'cube', lambda: 2 } });
    expect(look(editor.project)).toMatchObject({
      method: 'analogy',
      parameters: { style: 'cube', lambda: 2 },
    });
    const steps = [
      { method: 'cubic', parameters: { lambda: 0.1 } },
      { method: 'cubic', parameters: { lambda: 0.2 } },
    ];
    await editor.open(bytes, 'a.obj', { recipe: { steps } });
    expect(editor.project!.steps.map(({ parameters }) => parameters.lambda)).toEqual([0.1, 0.2]);
    expect(look(editor.project).result!.state).toBe('settled');
  });
});

describe('a gesture', () => {
  it('previews from where the shape is, settles from rest and is one entry', async () => {
    const { engine, editor, store, lambda, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    engine.calls.length = 0;
    for (const value of [0.5, 0.7, 0.9]) {
      editor.preview(lambda(value));
      await aTurn();
    }
    editor.commit(lambda(0.9), 'Cubeness');
    await quiet(store);
    expect(engine.calls).toEqual([
      'solve current 0.5',
      'solve current 0.7',
      'solve current 0.9',
      'solve rest 0.9',
    ]);
    expect(store.state.history.past).toHaveLength(1);
    expect(look(editor.project).result!.state).toBe('settled');
    expect(canvas.last).toEqual(expected(0.9));
    expect(store.state.history.past[0]!.after).toBe(editor.project);
  });

  it('that ends where it began leaves no entry and brings the shape back', async () => {
    const { editor, store, lambda } = desk();
    await editor.open(bytes, 'a.obj');
    const before = editor.project!;
    editor.preview(lambda(0.9));
    await quiet(store);
    editor.commit({ parameters: activeStep(before).parameters }, 'Cubeness');
    await quiet(store);
    expect(editor.project).toBe(before);
    expect(store.state.history.past).toHaveLength(0);
  });

  it('never takes a shape for settled that belongs to other values', async () => {
    const { editor, engine, store, lambda } = desk();
    await editor.open(bytes, 'a.obj');
    editor.commit(lambda(0.6), 'Cubeness');
    editor.commit(lambda(0.8), 'Cubeness');
    await quiet(store);
    editor.undo();
    expect(look(editor.project).parameters.lambda).toBe(0.6);
    engine.calls.length = 0;
    await editor.write('obj');
    expect(engine.calls).toEqual(['solve rest 0.6', 'write']);
  });
});

describe('undo and redo', () => {
  it('bring shapes back without solving', async () => {
    const { engine, editor, store, lambda, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    const start = look(editor.project).parameters.lambda as number;
    editor.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    engine.calls.length = 0;
    editor.undo();
    expect(canvas.last).toEqual(expected(start));
    editor.redo();
    expect(canvas.last).toEqual(expected(0.5));
    expect(engine.calls).toEqual([]);
    expect(editor.redo()).toBe(false);
  });

  it('stop what is running', async () => {
    const { editor, store, lambda } = desk({ steps: 50 });
    await editor.open(bytes, 'a.obj');
    const first = editor.project!;
    editor.commit(lambda(0.5), 'Cubeness');
    editor.undo();
    await quiet(store);
    expect(editor.project).toBe(first);
  });
});

describe('cancelling', () => {
  it('keeps what the carving had reached', async () => {
    const { editor, store } = desk({ steps: 1000, pause: () => new Promise((go) => setTimeout(go, 1)) });
    const opened = editor.open(bytes, 'a.obj');
    await until(() => store.state.activity.kind === 'solving' && store.state.activity.iteration >= 3);
    expect(editor.cancel()).toBe(true);
    await opened;
    expect(look(editor.project).result).toMatchObject({ state: 'stopped', outcome: 'cancelled' });
    expect(editor.cancel()).toBe(false);
  });
});

describe('cancelling a gesture', () => {
  it('keeps the shape when it ends, and settles it no more', async () => {
    const { engine, editor, store, lambda } = desk({
      pause: () => new Promise((go) => setTimeout(go, 1)),
    });
    await editor.open(bytes, 'a.obj');
    engine.calls.length = 0;
    editor.preview(lambda(0.9));
    editor.cancel();
    editor.commit(lambda(0.9), 'Cubeness');
    await quiet(store);
    expect(engine.calls).toEqual(['solve current 0.9']);
    expect(look(editor.project).result!.state).toBe('stopped');
    expect(store.state.history.past[0]!.after).toBe(editor.project);
  });
});

describe('dropping a gesture', () => {
  it('takes back what was previewed, and nothing else where nothing was', async () => {
    const { editor, store, lambda } = desk();
    await editor.open(bytes, 'a.obj');
    editor.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    const before = editor.project;
    expect(editor.dropGesture()).toBe(false);
    editor.preview(lambda(0.9));
    expect(editor.dropGesture()).toBe(true);
    expect(editor.project).toBe(before);
    expect(store.state.history.past).toHaveLength(1);
  });
});

describe('a worker that dies', () => {
  it('costs one retry', async () => {
    const { engine, editor, store, lambda } = desk();
    await editor.open(bytes, 'a.obj');
    engine.deaths = 1;
    editor.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    expect(store.state.notice).toBeNull();
    expect(look(editor.project).result!.state).toBe('settled');
  });

  it('twice leaves a sentence and a way to try again', async () => {
    const { engine, editor, store, lambda, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    const shown = canvas.last;
    engine.deaths = 2;
    editor.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    expect(store.state.notice!.text).toContain('worker');
    expect(canvas.last).toEqual(shown);
    store.state.notice!.action!.run();
    await quiet(store);
    expect(canvas.last).toEqual(expected(0.5));
  });
});

describe('a change of method', () => {
  it('and back loses no settings', async () => {
    const { editor, store, lambda } = desk();
    await editor.open(bytes, 'a.obj');
    editor.commit(lambda(0.77), 'Cubeness');
    await editor.chooseMethod('analogy', { style: 'octahedron' });
    editor.commit(lambda(3), 'Strength');
    await editor.chooseMethod('cubic');
    expect(look(editor.project)).toMatchObject({ method: 'cubic', parameters: { lambda: 0.77 } });
    await editor.chooseMethod('analogy');
    await quiet(store);
    expect(look(editor.project)).toMatchObject({
      method: 'analogy',
      parameters: { lambda: 3, style: 'octahedron' },
    });
  });
});

describe('comparing', () => {
  it('shows the file’s own shape and comes back', async () => {
    const { editor, presenter, canvas } = desk();
    await editor.open(bytes, 'a.obj');
    const styled = canvas.last;
    presenter.compare(true);
    expect(canvas.last).toEqual(tetrahedron().positions);
    presenter.compare(false);
    expect(canvas.last).toEqual(styled);
  });
});
