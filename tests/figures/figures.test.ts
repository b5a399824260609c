import { mkdirSync, writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { picture } from '../browser/support/browser.ts';
import { exported, shapedHeadless } from '../browser/support/headless.ts';
import { usePage } from '../browser/support/use-page.ts';
import { figures } from './figures.ts';
import { Hand } from './hand.ts';

/** With WHITTLE_FIGURES=1 the pictures and recipes of `public/docs/figures` are made anew. */
const folder = process.env.WHITTLE_FIGURES ? 'public/docs/figures' : null;
if (folder) mkdirSync(folder, { recursive: true });

const pages = usePage();
const window = { width: 1200, height: 800 };

it.each(figures)(
  '$id is made on the page by pointers alone, and by its recipe to the bit',
  async (figure) => {
    const page = await pages.open({ viewport: window });
    const hand = new Hand(page);
    if (figure.sample) await hand.openSample(figure.sample.title);
    const before = await picture(page);
    await figure.act(hand);
    await hand.rests();
    await page.locator('.strip').getByText('Turn', { exact: true }).click();
    expect(await picture(page)).not.toBe(before);
    const recipe = await exported(page, 'Recipe');
    const shaped = await exported(page, figure.sample?.format ?? 'glTF binary');
    const mesh = figure.sample?.path ?? 'public/samples/rabbit.glb';
    expect((await shapedHeadless(recipe, mesh)).equals(shaped.bytes)).toBe(true);
    if (!folder) return;
    writeFileSync(`${folder}/${figure.id}.whittle.json`, recipe.bytes);
    const clip = { x: 110, y: 80, width: 770, height: 660 };
    await page.keyboard.press('f');
    await page.mouse.move(20, 780);
    await picture(page);
    writeFileSync(`${folder}/${figure.id}.jpg`, await page.screenshot({ clip, type: 'jpeg', quality: 82 }));
  },
);
