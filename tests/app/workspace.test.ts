import { describe, expect, it } from 'vitest';
import { Display } from '../../web/document/display.ts';
import { Runner } from '../../web/document/runner.ts';
import { Store } from '../../web/document/store.ts';
import { Workspace } from '../../web/document/workspace.ts';
import { until } from '../fixtures/until.ts';
import { FakeEngine, type FakeOptions, tetrahedron } from './fake-engine.ts';

const bytes = Uint8Array.of(1);

class FakeCanvas {
  shown = 0;
  last = new Float64Array(0);
  show(): void {
    this.shown++;
  }
  update(positions: Float64Array): void {
    this.last = positions.slice();
  }
}

function desk(options: FakeOptions = {}) {
  const engine = new FakeEngine(options);
  const store = new Store();
  const canvas = new FakeCanvas();
  const display = new Display(
    canvas,
    () => 0,
    async () => {},
  );
  const workspace = new Workspace(store, new Runner(engine), display);
  const lambda = (value: number) => ({ parameters: { ...workspace.document!.parameters, lambda: value } });
  return { engine, store, canvas, display, workspace, lambda };
}

/** Lets everything that is under way come to its end. */
async function quiet(store: Store): Promise<void> {
  for (let turns = 0; turns < 500; turns++) {
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (store.state.activity.kind === 'idle' && turns > 5) return;
  }
  throw new Error('never came to rest');
}

const expected = (lambda: number) => tetrahedron().positions.map((x) => x * (1 + lambda));

describe('opening', () => {
  it('carves from rest, with frames, to a settled result', async () => {
    const { engine, workspace, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    const { lambda } = workspace.document!.parameters;
    expect(engine.calls).toEqual(['read', 'inspect', `solve rest ${lambda}`]);
    expect(workspace.document!.result!.state).toBe('settled');
    expect(canvas.last).toEqual(expected(lambda as number));
  });

  it('keeps the mesh that was there when the file is broken', async () => {
    const { workspace, store } = desk();
    await workspace.open(bytes, 'a.obj');
    const before = workspace.document;
    await workspace.open(bytes, 'broken.obj');
    expect(workspace.document).toBe(before);
    expect(store.state.notice).toMatchObject({ tone: 'error', text: 'broken.obj, line 3: not a number.' });
  });

  it('can be undone', async () => {
    const { workspace, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    await workspace.open(bytes, 'b.obj');
    expect(workspace.undo()).toBe(true);
    expect(workspace.document!.source.name).toBe('a.obj');
    expect(canvas.shown).toBe(3);
  });
});

describe('a gesture', () => {
  it('previews from where the shape is, settles from rest and is one entry', async () => {
    const { engine, workspace, store, lambda, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    engine.calls.length = 0;
    workspace.preview(lambda(0.5));
    workspace.preview(lambda(0.7));
    workspace.preview(lambda(0.9));
    workspace.commit(lambda(0.9), 'Cubeness');
    await quiet(store);
    expect(engine.calls).toEqual([
      'solve current 0.5',
      'solve current 0.7',
      'solve current 0.9',
      'solve rest 0.9',
    ]);
    expect(store.state.history.past).toHaveLength(1);
    expect(workspace.document!.result!.state).toBe('settled');
    expect(canvas.last).toEqual(expected(0.9));
    expect(store.state.history.past[0]!.after).toBe(workspace.document);
  });

  it('that ends where it began leaves no entry and brings the shape back', async () => {
    const { workspace, store, lambda } = desk();
    await workspace.open(bytes, 'a.obj');
    const before = workspace.document!;
    workspace.preview(lambda(0.9));
    await quiet(store);
    workspace.commit({ parameters: before.parameters }, 'Cubeness');
    await quiet(store);
    expect(workspace.document).toBe(before);
    expect(store.state.history.past).toHaveLength(0);
  });

  it('never stores a shape as settled that belongs to other values', async () => {
    const { workspace, store, lambda } = desk();
    await workspace.open(bytes, 'a.obj');
    workspace.commit(lambda(0.6), 'Cubeness');
    expect(workspace.document!.result!.state).toBe('preview');
    workspace.commit(lambda(0.8), 'Cubeness');
    await quiet(store);
    workspace.undo();
    expect(workspace.document!.parameters.lambda).toBe(0.6);
    expect(workspace.document!.result!.state).toBe('preview');
  });
});

describe('undo and redo', () => {
  it('bring shapes back without solving', async () => {
    const { engine, workspace, store, lambda, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    const start = workspace.document!.parameters.lambda as number;
    workspace.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    engine.calls.length = 0;
    workspace.undo();
    expect(canvas.last).toEqual(expected(start));
    workspace.redo();
    expect(canvas.last).toEqual(expected(0.5));
    expect(engine.calls).toEqual([]);
    expect(workspace.redo()).toBe(false);
  });

  it('stop what is running', async () => {
    const { workspace, store, lambda } = desk({ steps: 50 });
    await workspace.open(bytes, 'a.obj');
    const first = workspace.document!;
    workspace.commit(lambda(0.5), 'Cubeness');
    workspace.undo();
    await quiet(store);
    expect(workspace.document).toBe(first);
  });
});

describe('cancelling', () => {
  it('keeps what the carving had reached', async () => {
    const { workspace, store } = desk({ steps: 1000, pause: () => new Promise((go) => setTimeout(go, 1)) });
    const opened = workspace.open(bytes, 'a.obj');
    await until(() => store.state.activity.kind === 'solving' && store.state.activity.iteration >= 3);
    expect(workspace.cancel()).toBe(true);
    await opened;
    expect(workspace.document!.result).toMatchObject({ state: 'stopped', outcome: 'cancelled' });
    expect(workspace.cancel()).toBe(false);
  });
});

describe('cancelling a gesture', () => {
  it('keeps the shape when it ends, and settles it no more', async () => {
    const { engine, workspace, store, lambda } = desk({
      pause: () => new Promise((go) => setTimeout(go, 1)),
    });
    await workspace.open(bytes, 'a.obj');
    engine.calls.length = 0;
    workspace.preview(lambda(0.9));
    workspace.cancel();
    workspace.commit(lambda(0.9), 'Cubeness');
    await quiet(store);
    expect(engine.calls).toEqual(['solve current 0.9']);
    expect(workspace.document!.result!.state).toBe('stopped');
    expect(store.state.history.past[0]!.after).toBe(workspace.document);
  });
});

describe('a worker that dies', () => {
  it('costs one retry', async () => {
    const { engine, workspace, store, lambda } = desk();
    await workspace.open(bytes, 'a.obj');
    engine.deaths = 1;
    workspace.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    expect(store.state.notice).toBeNull();
    expect(workspace.document!.result!.state).toBe('settled');
  });

  it('twice leaves a sentence and a way to try again', async () => {
    const { engine, workspace, store, lambda, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    const shown = canvas.last;
    engine.deaths = 2;
    workspace.commit(lambda(0.5), 'Cubeness');
    await quiet(store);
    expect(store.state.notice!.text).toContain('worker');
    expect(canvas.last).toEqual(shown);
    store.state.notice!.action!.run();
    await quiet(store);
    expect(canvas.last).toEqual(expected(0.5));
  });
});

describe('writing', () => {
  it('settles a preview first', async () => {
    const { engine, workspace, store, lambda } = desk();
    await workspace.open(bytes, 'a.obj');
    workspace.commit(lambda(0.6), 'Cubeness');
    workspace.commit(lambda(0.8), 'Cubeness');
    await quiet(store);
    workspace.undo();
    engine.calls.length = 0;
    expect((await workspace.write('obj'))!.bytes).toEqual(Uint8Array.of(1, 2, 3));
    expect(engine.calls).toEqual(['solve rest 0.6', 'write']);
    expect(workspace.document!.result!.state).toBe('settled');
  });
});

describe('comparing', () => {
  it('shows the file’s own shape and comes back', async () => {
    const { workspace, display, canvas } = desk();
    await workspace.open(bytes, 'a.obj');
    const styled = canvas.last;
    display.compare(true);
    expect(canvas.last).toEqual(tetrahedron().positions);
    display.compare(false);
    expect(canvas.last).toEqual(styled);
  });
});
