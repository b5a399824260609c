import { describe, expect, it } from 'vitest';
import { Comparison, type ComparisonParts } from '../../src/editor/comparison.ts';
import { activeStep } from '../../src/editor/project.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';

const bytes = Uint8Array.of(1);

/** An editor with a mesh posed in it, and what is compared: each run as start, edges and λ-free number of the run. */
async function compared(values: readonly string[], refused?: string) {
  const { engine, store, editor, canvas } = headlessEditor();
  const runs: string[] = [];
  const meshes = new Set<Mesh>();
  const solve = engine.solve.bind(engine);
  engine.solve = (mesh, settings, options) => {
    const { regularizer } = settings.parameters;
    runs.push(`${settings.start} ${regularizer}`);
    meshes.add(mesh);
    if (regularizer === refused) throw new WhittleError('bad-parameter', 'Not with this mesh.');
    return solve(mesh, { ...settings, parameters: { ...settings.parameters, lambda: 1 } }, options);
  };
  await editor.open(bytes, 'a.obj', {
    recipe: { steps: [{ method: 'arap', parameters: { regularizer: 'arap', maxIterations: 5 } }] },
  });
  runs.length = 0;
  const drawn = new Map<number, Float64Array>();
  const parts: ComparisonParts = {
    store,
    engine,
    resolver: editor.resolver,
    isFollowing: () => editor.isFollowing,
    draw: async (picture, positions) => void drawn.set(picture, positions.slice()),
    changed: () => {},
  };
  const comparison = new Comparison(parts);
  comparison.compare('regularizer', values);
  const settled = async () => {
    await quiet(store);
    while (comparison.pictures.some(({ isRunning }) => isRunning)) await quiet(store);
  };
  await settled();
  const change = (maxIterations: number) => ({
    parameters: { ...activeStep(editor.project!).parameters, maxIterations },
  });
  return { engine, store, editor, canvas, runs, meshes, drawn, comparison, settled, change };
}

describe('a comparison', () => {
  it('runs the step once with each value, from rest, on meshes of their own, and draws what comes', async () => {
    const { runs, meshes, drawn, comparison, editor } = await compared(['farap', 'acap']);
    expect(runs).toEqual(['rest farap', 'rest acap']);
    expect(meshes.has(editor.project!.mesh)).toBe(true);
    expect(meshes.size).toBe(3);
    expect(comparison.pictures.map(({ result }) => result?.state)).toEqual(['settled', 'settled']);
    expect(comparison.pictures.map(({ result }) => result?.of.parameters.regularizer)).toEqual([
      'farap',
      'acap',
    ]);
    for (const [k, { result }] of comparison.pictures.entries())
      expect(drawn.get(k)).toEqual(result!.positions);
  });

  it('follows a gesture from where it is, and settles when that has ended, after the editor’s own run', async () => {
    const { runs, editor, settled, change, comparison } = await compared(['farap', 'acap']);
    runs.length = 0;
    editor.preview(change(6));
    await settled();
    expect(runs.toSorted()).toEqual(['current acap', 'current arap', 'current farap']);
    expect(comparison.pictures.map(({ result }) => result?.state)).toEqual(['preview', 'preview']);
    runs.length = 0;
    editor.commit(change(7), 'Iterations');
    await settled();
    expect(runs).toEqual(['rest arap', 'rest farap', 'rest acap']);
  });

  it('is never a step for undo; what is taken from it is one, and is not solved again', async () => {
    const { runs, editor, store, settled, comparison, canvas } = await compared(['farap']);
    const entries = () => store.state.history.past.length;
    expect(entries()).toBe(0);
    const { result } = comparison.pictures[0]!;
    runs.length = 0;
    comparison.compare('regularizer', ['arap']);
    const parameters = { ...activeStep(editor.project!).parameters, regularizer: 'farap' };
    editor.commit({ parameters }, 'Edges', result!);
    await settled();
    expect([runs, entries()]).toEqual([[], 1]);
    expect(activeStep(editor.project!).result).toBe(result);
    expect(canvas.last).toEqual(result!.positions);
    // What the step had is in the picture, as it was.
    expect(comparison.pictures[0]!.result?.of.parameters.regularizer).toBe('arap');
  });

  it('says why a picture has no shape, and tries no second time before something changes', async () => {
    const { runs, comparison, store, settled, editor, change } = await compared(['farap', 'acap'], 'farap');
    expect(comparison.pictures[0]).toMatchObject({ result: null, failure: 'Not with this mesh.' });
    expect(comparison.pictures[1]!.result?.state).toBe('settled');
    expect(store.state.notice).toBeNull();
    runs.length = 0;
    editor.commit(change(8), 'Iterations');
    await settled();
    expect(runs).toEqual(['rest arap', 'rest farap', 'rest acap']);
  });

  it('gives the worker its meshes back', async () => {
    const { engine, comparison, editor, meshes } = await compared(['farap', 'acap']);
    comparison.compare('regularizer', ['acap']);
    expect(engine.held.size).toBe(2);
    comparison.dispose();
    expect([...engine.held]).toEqual([editor.project!.mesh]);
    expect(meshes.size).toBe(3);
  });
});
