import { expect, it } from 'vitest';
import { activeStep, type Project } from '../../src/editor/project.ts';
import { withStep } from '../../src/editor/steps.ts';
import type { LinesLayer } from '../../src/viewer/layers/layer.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';
import { followLines } from '../../web/app/line-paint.ts';
import { headlessEditor } from '../fixtures/headless-editor.ts';

/** A project whose result knows of lines. */
async function drawing() {
  const { editor, store } = headlessEditor();
  await editor.open(Uint8Array.of(1), 'a.obj');
  const layers = new Map<string, LinesLayer | null>();
  followLines(store, {
    set: (name: string, layer: LinesLayer | null) => layers.set(name, layer),
  } as unknown as Layers);
  const tell = (lines: Readonly<Record<string, readonly number[]>>) => {
    const project: Project = store.state.project!;
    const step = activeStep(project);
    const fields = Object.entries(lines).map(([name, ends]) => ({
      ...{ name, label: name, per: 'line' as const, unit: '', values: Float64Array.from(ends) },
    }));
    store.set({ project: withStep(project, { ...step, result: { ...step.result!, fields } }) });
  };
  const choose = (...lines: string[]) => store.set({ look: { ...store.state.look, lines } });
  const drawn = () => [...layers].filter(([, layer]) => layer !== null).map(([name]) => name);
  return { store, layers, tell, choose, drawn };
}

it('draws the lines that are chosen, each in a colour that it keeps, and follows the project', async () => {
  const { store, layers, tell, choose, drawn } = await drawing();
  tell({ creases: [0, 1, 1, 2], straight: [2, 3], none: [] });
  expect(drawn()).toEqual([]);
  choose('straight');
  expect(drawn()).toEqual(['found straight']);
  const { positions, color } = layers.get('found straight')!;
  expect(Array.from(positions!)).toEqual([2, 3]);
  choose('creases', 'straight');
  expect(drawn().toSorted()).toEqual(['found creases', 'found straight']);
  expect(layers.get('found straight')!.color).toBe(color);
  expect(layers.get('found creases')!.color).not.toBe(color);
  expect(store.state.lines.map(({ name }) => name)).toEqual(['creases', 'straight']);
  tell({ creases: [3, 0], straight: [] });
  expect(drawn()).toEqual(['found creases']);
  expect(Array.from(layers.get('found creases')!.positions!)).toEqual([3, 0]);
  choose();
  expect([drawn(), store.state.lines]).toEqual([[], []]);
});
