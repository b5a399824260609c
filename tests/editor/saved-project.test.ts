import { describe, expect, it } from 'vitest';
import { activeStep } from '../../src/editor/project.ts';
import { beginSaved, saveProject } from '../../src/editor/saved-project.ts';
import { writePng } from '../../src/inputs/images/png.ts';
import { decodePng } from '../../src/inputs/images/read.ts';
import { blankMap, sphereMap } from '../../src/inputs/styles/captures.ts';
import { unit } from '../../src/mesh/vectors.ts';
import type { Asset } from '../../src/recipe/index.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';

const bytes = Uint8Array.of(1, 2, 3);
const painted: Asset = { kind: 'gauss-map', map: sphereMap(([x, y, z]) => unit([x, y, z - 0.3])) };

/** Three steps: one on with a painted ball, one off, one that was another method before. */
async function project() {
  const { editor, store, engine } = headlessEditor();
  const assets = new Map([
    ['painted.png', painted],
    ['../up/box.obj', { ...painted, file: bytes } as Asset],
    ['unused.png', painted],
  ]);
  await editor.open(bytes, 'a.obj', {
    recipe: {
      steps: [
        { method: 'analogy', parameters: { style: 'painted.png', lambda: 2 } },
        { method: 'cubic', parameters: { lambda: 0.25 } },
        { method: 'analogy', parameters: { style: '../up/box.obj' } },
      ],
    },
    assets,
    address: 'samples/a.obj',
  });
  editor.switchStep(editor.project!.steps[1]!.id, false);
  editor.activate(editor.project!.steps[0]!.id);
  editor.restyle({ method: 'developable', parameters: { creases: 0.5 } }, 'Developable');
  await quiet(store);
  return { project: editor.project!, opening: { engine, decodeImage: decodePng } };
}

describe('a saved project', () => {
  it('begins as it was: steps on and off, remembered values, the active step, assets, where it came from', async () => {
    const { project: before, opening } = await project();
    const { stack, assets, address } = await beginSaved(saveProject(before), opening);
    const said = ({ method, isOn, parameters }: (typeof before.steps)[number]) => [
      method,
      isOn,
      parameters.lambda,
    ];
    expect(stack!.steps.map(said)).toEqual([
      ['developable', true, 20],
      ['cubic', false, 0.25],
      ['analogy', true, 1],
    ]);
    expect(stack!.steps[0]!.parameters.creases).toBe(0.5);
    expect(stack!.steps[0]!.remembered.analogy).toMatchObject({ style: 'painted.png', lambda: 2 });
    expect(stack!.active).toBe(stack!.steps[0]!.id);
    expect(address).toBe('samples/a.obj');
    expect(assets!.get('painted.png')).toMatchObject({ map: (painted as { map: unknown }).map });
  });

  it('has the steps that are on in the recipe alone, and no assets that nobody names', async () => {
    const { project: before } = await project();
    const saved = saveProject(before);
    expect(JSON.parse(saved.recipe!).steps).toEqual([
      { method: 'developable', creases: 0.5 },
      { method: 'analogy', style: 'asset-box.obj' },
    ]);
    expect([...saved.assets.keys()]).toEqual(['painted.png', 'asset-box.obj']);
    expect(JSON.parse(saved.workspace!).steps).toEqual([
      { remembered: [{ method: 'analogy', style: 'painted.png', lambda: 2 }] },
      { off: { method: 'cubic', lambda: 0.25 } },
      {},
    ]);
  });

  it('follows a recipe that was changed by hand', async () => {
    const { project: before, opening } = await project();
    const recipe = '{"whittle": 1, "steps": [{"method": "cubic", "lambda": 1}]}';
    const { stack } = await beginSaved({ ...saveProject(before), recipe }, opening);
    expect(stack!.steps.map(({ parameters }) => parameters.lambda)).toEqual([1]);
  });

  it('opens without what no step needs, and refuses a broken file that one needs', async () => {
    const { project: before, opening } = await project();
    const saved = saveProject(before);
    const photo = writePng({ width: 8, height: 4, data: new Uint8Array(128) });
    const broken = { ...saved, assets: new Map([...saved.assets, ['painted.png', photo] as const]) };
    expect((await beginSaved(broken, opening)).assets!.has('painted.png')).toBe(false);
    const used = '{"whittle": 1, "steps": [{"method": "analogy", "style": "painted.png"}]}';
    await expect(beginSaved({ ...broken, recipe: used }, opening)).rejects.toThrow(/^painted\.png/);
  });

  it('is kept whole where every step is off', async () => {
    const { editor, engine } = headlessEditor();
    await editor.open(bytes, 'a.obj', { method: 'cubic', parameters: { lambda: 0.7 } });
    editor.switchStep(editor.project!.active, false);
    const saved = saveProject(editor.project!);
    expect(saved).not.toHaveProperty('recipe');
    const { stack } = await beginSaved(saved, { engine, decodeImage: decodePng });
    expect(stack!.steps).toMatchObject([{ isOn: false, parameters: { lambda: 0.7 } }]);
  });
});

describe('a recipe that is put on the mesh', () => {
  it('replaces the steps as one entry, with defaults for what it leaves out', async () => {
    const { editor, store } = headlessEditor();
    await editor.open(bytes, 'a.obj');
    const before = editor.project!;
    const recipe = { steps: [{ method: 'analogy', parameters: { style: 'own.png' } }] };
    editor.takeRecipe(
      recipe,
      new Map([['own.png', { kind: 'gauss-map', map: blankMap() }]]),
      'Recipe a.json',
    );
    await quiet(store);
    expect(activeStep(editor.project!).parameters).toMatchObject({
      style: 'own.png',
      lambda: 1,
      mapping: 'auto',
    });
    expect(store.state.history.past.map(({ label }) => label)).toEqual(['Recipe a.json']);
    editor.undo();
    expect(editor.project!.steps).toEqual(before.steps);
  });
});
