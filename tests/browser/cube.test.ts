import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { picture } from './support/browser.ts';
import { done, drag, type Place, takeTool, typeOver } from './support/hands.ts';
import { exported, shapedHeadless } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** On the cube around the rabbit as it opens, in a window of 1200×800. */
const topArrow: Place = [593, 195];
const levelRing: Place = [593, 433];

/** The one step of the recipe that the page saves. */
async function step() {
  const { bytes } = await exported(page, 'Recipe');
  return JSON.parse(bytes.toString()).steps[0] as {
    lambdaAxes?: number[];
    orientation?: number[];
    polyhedron?: string | number[][];
  };
}

beforeEach(async () => {
  page = await pages.open();
  await takeTool(page, 'Cube');
});

it('stretches the cube by a side, as one entry that the command line repeats to the bit', async () => {
  const before = await picture(page);
  await drag(page, topArrow, [593, 160], [593, 120]);
  await done(page, 'Stretch the cube');
  const { lambdaAxes } = await step();
  expect(lambdaAxes![1]).toBeGreaterThan(1.1);
  expect([lambdaAxes![0], lambdaAxes![2]]).toEqual([1, 1]);
  expect(await page.locator('[data-stretch=y]').inputValue()).toBe(String(lambdaAxes![1]));
  expect(await picture(page)).not.toBe(before);
  const recipe = await exported(page, 'Recipe');
  const shaped = await exported(page, 'glTF binary');
  expect((await shapedHeadless(recipe, 'public/samples/rabbit.glb')).equals(shaped.bytes)).toBe(true);
  await typeOver(page.locator('[data-stretch=y]'), '1');
  await page.waitForFunction(
    () => document.querySelector<HTMLInputElement>('[data-stretch=y]')!.value === '1',
  );
  expect((await step()).lambdaAxes).toEqual([1, 1, 1]);
});

it('turns it by a ring about the axis of the ring, and straightens it', async () => {
  await drag(page, levelRing, [630, 436], [670, 436]);
  await done(page, 'Turn the cube');
  const [x, y, z, w] = (await step()).orientation!;
  expect(Math.hypot(x!, z!)).toBeLessThan(1e-6);
  expect(Math.abs(y!)).toBeGreaterThan(0.05);
  expect(Math.hypot(y!, w!)).toBeCloseTo(1, 9);
  await page.locator('[data-act=straighten]').click();
  await done(page, 'Straighten the cube');
  expect((await step()).orientation).toEqual([0, 0, 0, 1]);
});

it('takes polyhedra by their pictures and edges of one’s own', async () => {
  await page.locator('[data-polyhedron=hexagonal-prism]').click();
  await done(page, 'Polyhedron');
  expect((await step()).polyhedron).toBe('hexagonal-prism');
  await page.locator('[data-polyhedron=own]').click();
  await page.waitForSelector('.own-rows');
  await typeOver(page.locator('[data-row="3"][data-axis="1"]'), '0.4');
  await page.waitForSelector('whittle-status[data-activity=idle]');
  const { polyhedron } = await step();
  expect(polyhedron).toHaveLength(4);
  expect((polyhedron as number[][])[3]).toEqual([0, 0.4, 0]);
});

it('passes axe', async () => {
  await page.locator('[data-polyhedron=own]').click();
  await page.waitForSelector('.own-rows');
  expect(await violations(page)).toEqual([]);
});
