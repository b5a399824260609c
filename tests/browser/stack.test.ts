import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { carved, picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { exported, shapedHeadless } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

const rows = () => page.locator('.stack .step-name').allInnerTexts();
const undo = () => page.locator('[data-act=undo]');

/** Waits until a change of the stack has begun to be solved, or needs no solving, and has ended. */
async function settled(steps: number): Promise<void> {
  await page.waitForFunction(
    (count) => document.querySelectorAll('.stack li').length === count || count < 2,
    steps,
  );
  await carved(page);
}

async function add(method: string, steps: number): Promise<void> {
  await page.getByRole('button', { name: 'Add a step' }).click();
  await page.getByRole('menuitem', { name: new RegExp(`^${method}`) }).click();
  await settled(steps);
}

it('is built, switched, reordered, undone, and saved as a recipe that gives the same bytes without the page', async () => {
  page = await pages.open();
  const single = await picture(page);
  await add('Style', 2);
  await add('Paper', 3);
  expect(await rows()).toEqual(['1Cubic', '2Style: octahedron', '3Paper']);
  const whole = await picture(page);

  await page.getByLabel('Style: octahedron is on').uncheck();
  await settled(3);
  const without = await picture(page);
  expect(without).not.toBe(whole);
  await page.locator('[data-step="3"] .step-name').click();
  await page.locator('[data-act=step-up]').click();
  await settled(3);
  await page.locator('[data-act=step-up]').click();
  await settled(3);
  expect(await rows()).toEqual(['1Paper', '2Cubic', '3Style: octahedron']);
  expect(await picture(page)).not.toBe(without);

  const recipe = await exported(page, 'Recipe');
  const shaped = await exported(page, 'glTF binary');
  expect(JSON.parse(recipe.bytes.toString()).steps).toHaveLength(2);
  expect((await shapedHeadless(recipe, 'public/samples/rabbit.glb')).equals(shaped.bytes)).toBe(true);

  while (await undo().isEnabled()) await undo().click();
  await carved(page);
  expect(await page.locator('.stack').count()).toBe(0);
  expect(await picture(page)).toBe(single);
});

it('goes back into a step, edits it alone and shows the whole again', async () => {
  page = await pages.open();
  await add('Paper', 2);
  const before = await picture(page);
  await page.locator('[data-step="1"] .step-name').click();
  expect(await page.locator('#parameter-lambda').count()).toBe(1);
  await page.locator('#parameter-lambda').focus();
  await page.keyboard.press('End');
  await settled(2);
  await page.waitForFunction(() =>
    /150 iterations/.test(document.querySelector('.sentence')?.textContent ?? ''),
  );
  expect(await picture(page)).not.toBe(before);
});

it.runIf(canEmulate).each([
  ['in dark', { colorScheme: 'dark' }],
  ['on a phone', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }],
] as const)('passes axe %s', async (_, options) => {
  page = await pages.open(options);
  await add('Blocks', 2);
  expect(await violations(page)).toEqual([]);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
});
