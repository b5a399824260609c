import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { picture } from '../browser/support/browser.ts';
import { exported, shapedHeadless } from '../browser/support/headless.ts';
import { usePage } from '../browser/support/use-page.ts';
import { objPositions } from '../fixtures/mesh-files.ts';
import { ablations } from './ablations.ts';
import type { FigureMesh, Outcome } from './figure.ts';
import { figures } from './figures.ts';
import { Hand } from './hand.ts';
import { Showroom } from './showroom.ts';

/** With WHITTLE_FIGURES=1 the pictures, the recipes and their page under `public/docs/figures` are made anew. */
const showroom = process.env.WHITTLE_FIGURES ? new Showroom('public/docs/figures') : null;

const pages = usePage();
const window = { width: 1200, height: 800 };

it.each(figures)(
  '$id is made on the page by pointer and keys, and by its recipe to the bit',
  async (figure) => {
    const page = await pages.open({ viewport: window });
    const hand = new Hand(page);
    const { mesh } = figure;
    if (mesh?.bytes) await hand.dropFile(mesh.title, mesh.bytes());
    else if (mesh) await hand.openSample(mesh.title);
    const before = await picture(page);
    await figure.act(hand);
    await hand.rests();
    await hand.takes('Turn');
    expect(await picture(page)).not.toBe(before);
    const recipe = await exported(page, 'Recipe');
    const shaped = await exported(page, mesh?.format ?? 'glTF binary');
    const ball = recipe.bytes.includes('strength.png') ? [await hand.savesBall()] : [];
    expect((await shapedHeadless(recipe, pathOf(mesh), ball)).equals(shaped.bytes)).toBe(true);
    figure.claims?.(outcomeOf(recipe.bytes, shaped.bytes));
    await showroom?.take(figure, hand, [{ ...recipe, name: `${figure.id}.whittle.json` }, ...ball]);
  },
);

afterAll(() => showroom?.open([...figures, ...ablations]));

function outcomeOf(recipe: Buffer, obj: Buffer): Outcome {
  const step = JSON.parse(recipe.toString()).steps.at(-1);
  return {
    positions: Float64Array.from(objPositions(obj.toString())),
    handles: step.handles ?? { vertices: [], targets: [] },
  };
}

/** Where the mesh lies as a file. */
function pathOf(mesh?: FigureMesh): string {
  if (!mesh) return 'public/samples/rabbit.glb';
  if (!mesh.bytes) return mesh.path;
  const path = join(mkdtempSync(join(tmpdir(), 'whittle-figure-')), mesh.title);
  writeFileSync(path, mesh.bytes());
  return path;
}
