import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { done, drag, fingers, type Place, takeTool, typeOver } from './support/hands.ts';
import { exported, shapedHeadless } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** On the rabbit as it opens, in a window of 1200×800. */
const ear: Place = [560, 290];
const flank: Place = [560, 500];

const groups = () => page.locator('.groups .group-name').allInnerTexts();
const undo = () => page.locator('[data-act=undo]');

/** The steps of the recipe that the page saves. */
async function recipe() {
  const { bytes } = await exported(page, 'Recipe');
  return JSON.parse(bytes.toString()) as {
    steps: { handles?: { vertices: number[]; targets: number[][] } }[];
    groups?: { name: string; vertices: number[] }[];
  };
}

beforeEach(async () => {
  page = await pages.open();
  await takeTool(page, 'Move');
});

it('pulls what is under the brush while its base is held, as one entry that the command line repeats to the bit', async () => {
  const before = await picture(page);
  await drag(page, ear, [580, 230], [600, 180]);
  await done(page, 'Pull');
  expect(await groups()).toEqual(['Moved', 'Base']);
  expect(await picture(page)).not.toBe(before);

  const saidBy = await exported(page, 'Recipe');
  const shaped = await exported(page, 'glTF binary');
  const { handles } = JSON.parse(saidBy.bytes.toString()).steps[0];
  expect(handles.vertices.length).toBeGreaterThan(50);
  expect((await shapedHeadless(saidBy, 'public/samples/rabbit.glb')).equals(shaped.bytes)).toBe(true);

  await undo().click();
  expect(await undo().isEnabled()).toBe(false);
  await page.waitForFunction(() => document.querySelectorAll('.groups li').length === 0);
});

it('paints what is held and lets go of it', async () => {
  await page.locator('[data-mode=hold]').click();
  await drag(page, flank, [600, 520], [640, 500]);
  await done(page, 'Hold');
  expect(await groups()).toEqual(['Held']);
  const held = (await recipe()).steps[0]!.handles!.vertices.length;
  await page.locator('[data-mode=let-go]').click();
  await drag(page, flank, [570, 500]);
  await done(page, 'Let go');
  const left = (await recipe()).steps[0]!.handles!.vertices.length;
  expect(left).toBeGreaterThan(0);
  expect(left).toBeLessThan(held);
  await page.locator('[data-act=let-all-go]').click();
  await done(page, 'Let all go');
  expect(await recipe()).not.toHaveProperty('groups');
});

it('moves a group by keys as Blender does, and by numbers', async () => {
  await drag(page, ear, [570, 285]);
  await done(page, 'Pull');
  const height = async () => Number(await page.locator('[data-axis=y]').inputValue());
  const before = await height();
  await page.keyboard.type('gy0.25');
  await page.waitForFunction(() =>
    document.querySelector('.tool-options h2')?.textContent?.includes('along y by 0.25'),
  );
  await page.keyboard.press('Enter');
  await done(page, 'Move');
  expect(await height()).toBeCloseTo(before + 0.25, 3);
  await page.keyboard.type('gx9');
  await page.keyboard.press('Escape');
  expect(await height()).toBeCloseTo(before + 0.25, 3);
  await typeOver(page.locator('[data-axis=y]'), '0.5');
  await page.waitForFunction(
    () => Number(document.querySelector<HTMLInputElement>('[data-axis=y]')!.value) === 0.5,
  );
});

it('is cancelled by Escape in the middle of a drag, and nothing is left of it', async () => {
  const before = await picture(page);
  await page.mouse.move(...ear);
  await page.mouse.down();
  await page.mouse.move(600, 200, { steps: 5 });
  await page.waitForFunction(() => document.querySelectorAll('.groups li').length === 2);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelectorAll('.groups li').length === 0);
  await page.mouse.move(20, 400);
  expect(await picture(page)).toBe(before);
  expect(await undo().isEnabled()).toBe(false);
});

it('works from the keyboard alone, and turns the view where there is nothing to take', async () => {
  await page.locator('#canvas').focus();
  // The cross begins in the middle of the canvas, which is on the flank.
  await page.keyboard.press('ArrowUp');
  await page.keyboard.down('Enter');
  for (let k = 0; k < 4; k++) await page.keyboard.press('ArrowUp');
  await page.keyboard.up('Enter');
  await done(page, 'Pull');
  expect(await groups()).toContain('Moved');
  const before = await picture(page);
  await page.keyboard.press('v');
  await page.locator('#canvas').focus();
  await page.keyboard.press('ArrowRight');
  expect(await picture(page)).not.toBe(before);
});

it.runIf(canEmulate)('gives one finger to the tool and two to the camera', async () => {
  page = await pages.open({ hasTouch: true });
  await takeTool(page, 'Move');
  const touch = await fingers(page);
  const before = await picture(page);
  // A second finger in the middle of a pull: nothing was pulled, and the two come closer to the mesh.
  await touch('touchStart', [500, 300]);
  await touch('touchMove', [510, 290]);
  await touch('touchStart', [510, 290], [620, 480]);
  for (let k = 1; k <= 6; k++)
    await touch('touchMove', [510 - 8 * k, 290 - 8 * k], [620 + 8 * k, 480 + 8 * k]);
  await touch('touchEnd');
  await page.waitForFunction(() => document.querySelectorAll('.groups li').length === 0);
  expect(await undo().isEnabled()).toBe(false);
  expect(await picture(page)).not.toBe(before);
  await page.keyboard.press('f');
  await picture(page);
  await touch('touchStart', ear);
  for (let k = 1; k <= 5; k++) await touch('touchMove', [ear[0] + 5 * k, ear[1] - 12 * k]);
  await touch('touchEnd');
  await done(page, 'Pull');
});

it('passes axe with its options open', async () => {
  await drag(page, ear, [580, 230]);
  await done(page, 'Pull');
  expect(await violations(page)).toEqual([]);
});
