import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { saved } from './support/downloads.ts';
import { done, drag, type Place, takeTool } from './support/hands.ts';
import { exported, shapedHeadless } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** On the rabbit as it opens, in a window of 1200×800. */
const cheek: Place = [640, 430];
const flank: Place = [560, 500];

interface SavedStep {
  readonly lambda: number;
  readonly lambdaPerVertex?: readonly number[];
  readonly lambdaOnGaussMap?: string;
}

async function recipe() {
  const file = await exported(page, 'Recipe');
  const [step] = JSON.parse(file.bytes.toString()).steps as SavedStep[];
  return { file, step: step! };
}

const look = (name: string) =>
  process.env.LOOKS ? page.screenshot({ path: `${process.env.LOOKS}/${name}.png` }) : null;

/** The window's place of a point of the ball, from −1 to 1. */
async function onBall(x: number, y: number): Promise<Place> {
  const box = (await page.locator('whittle-strength-ball canvas').boundingBox())!;
  return [box.x + (box.width * (1 + 0.92 * x)) / 2, box.y + (box.height * (1 - 0.92 * y)) / 2];
}

beforeEach(async () => {
  page = await pages.open();
  await takeTool(page, 'Paint');
});

it('paints on the mesh where the style is weaker, as one entry that the command line repeats to the bit', async () => {
  await look('paint-begin');
  await drag(page, cheek, [620, 400], flank);
  await done(page, 'Paint strength');
  await look('paint-surface');
  const shaped = await exported(page, 'glTF binary');
  const { file, step } = await recipe();
  const shares = step.lambdaPerVertex!.map((value) => value / step.lambda);
  expect(Math.min(...shares)).toBeCloseTo(0.5, 6);
  expect(shares.filter((share) => share === 1).length).toBeGreaterThan(shares.length / 3);
  expect((await shapedHeadless(file, 'public/samples/rabbit.glb')).equals(shaped.bytes)).toBe(true);
  await page.keyboard.press('Control+z');
  await page.waitForSelector('[data-act=undo]:disabled');
  expect((await recipe()).step).not.toHaveProperty('lambdaPerVertex');
});

it('paints by direction on the ball, which shows where the mesh looks that is pointed at', async () => {
  const ball = page.locator('whittle-strength-ball canvas');
  await page.mouse.move(...flank);
  await look('paint-pointed');
  await page.locator('[data-act=strong-no-way]').click();
  await done(page, 'No strength');
  await page.locator('[data-mode=add]').click();
  await page.mouse.move(...(await onBall(0, 0.9)));
  await look('paint-lit');
  await drag(page, await onBall(0, 0.9), await onBall(0.2, 0.8), await onBall(-0.2, 0.8));
  await done(page, 'Paint strength');
  await look('paint-ball');
  const { step } = await recipe();
  expect(step.lambdaOnGaussMap).toBe('strength.png');
  const { bytes } = await saved(page, () => page.locator('[data-act=save-ball]').click());
  const shaped = () => exported(page, 'glTF binary').then((file) => file.bytes);
  const before = await shaped();
  await page.locator('[data-act=strong-all-ways]').click();
  await done(page, 'Full strength');
  expect((await shaped()).equals(before)).toBe(false);
  await page
    .locator('.tool-options input[type=file]')
    .setInputFiles({ name: 'up.png', mimeType: 'image/png', buffer: bytes });
  await done(page, 'Load a ball');
  expect((await shaped()).equals(before)).toBe(true);
  await ball.focus();
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', ' ']) await page.keyboard.press(key);
  await done(page, 'Paint strength');
});

it('takes a stroke back with Escape, and nothing but that stroke', async () => {
  await drag(page, cheek, [620, 400]);
  await done(page, 'Paint strength');
  const before = (await recipe()).step;
  for (const places of [[flank], [flank, [520, 480]]] as Place[][]) {
    await page.mouse.move(...places[0]!);
    await page.mouse.down();
    for (const place of places.slice(1)) await page.mouse.move(...place, { steps: 4 });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await done(page, 'Paint strength');
    expect((await recipe()).step).toEqual(before);
  }
});

it('keeps what is painted a share of λ when that is changed', async () => {
  await page.locator('[data-act=strong-nowhere]').click();
  await done(page, 'No strength');
  await page.locator('[data-mode=set]').click();
  await drag(page, cheek, flank);
  await done(page, 'Paint strength');
  const before = (await recipe()).step;
  const slider = page.getByRole('slider', { name: 'Cubeness' });
  await slider.focus();
  await slider.press('End');
  await page.waitForSelector('whittle-status[data-activity=idle]');
  const { step } = await recipe();
  expect(step.lambda).toBe(2);
  const scale = step.lambda / before.lambda;
  for (const [k, value] of step.lambdaPerVertex!.entries())
    expect(value).toBeCloseTo(scale * before.lambdaPerVertex![k]!, 9);
});

it('is at home on a phone, and says what it is to those who listen', async () => {
  expect(await violations(page)).toEqual([]);
  await page.evaluate(() => {
    document.documentElement.dataset.theme = 'dark';
  });
  await look('paint-dark');
  page = await pages.open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await takeTool(page, 'Paint');
  await look('paint-phone');
  expect(await violations(page)).toEqual([]);
});
