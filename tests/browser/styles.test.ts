import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { isPng, writePng } from '../../src/inputs/images/png.ts';
import { pixelsOfMap, sphereMap } from '../../src/inputs/styles/captures.ts';
import { unit } from '../../src/mesh/vectors.ts';
import { violations } from './support/axe.ts';
import { carved, drop, picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { saved } from './support/downloads.ts';
import { usePage } from './support/use-page.ts';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

const pages = usePage();
let page: Page;

const act = (name: string) => page.locator(`[data-act=${name}]`);
const undoLabel = () => act('undo').getAttribute('aria-label');

/** The page with a style on and all its pictures taken. */
async function openStyles(options = {}): Promise<void> {
  page = await pages.open(options);
  await page.locator('.switch label').nth(1).click();
  await page.waitForSelector('.tile[aria-selected=true]');
  await carved(page);
}

async function chosen(name: string): Promise<void> {
  await page.waitForFunction(
    (wanted) => document.querySelector<HTMLElement>('.tile[aria-selected=true]')?.title === wanted,
    name,
  );
  await carved(page);
}

it('restyles at a click, one entry each, and undoes', async () => {
  await openStyles();
  expect(await undoLabel()).toBe('Undo Octahedron');
  const octahedral = await picture(page);
  await page.locator('[data-style=shapes-cube]').click();
  await chosen('Cube');
  expect(await picture(page)).not.toBe(octahedral);
  await page.locator('[data-style=meshes-oloid]').click();
  await chosen('Oloid');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await chosen('Octahedron');
  expect(await picture(page)).toBe(octahedral);
  await page.keyboard.press('Control+z');
  expect(await page.locator('.switch input').first().isChecked()).toBe(true);
});

it('walks the gallery with arrow keys and takes with Enter', async () => {
  await openStyles();
  await page.locator('.tile[aria-selected=true]').focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await chosen('Bevelled cube');
  expect(await page.evaluate(() => document.activeElement?.getAttribute('aria-selected'))).toBe('true');
});

it('fills every picture, soon and not all at once', async () => {
  await openStyles();
  await page.waitForFunction(() =>
    [...document.querySelectorAll<HTMLCanvasElement>('.tile canvas')].every((canvas) =>
      canvas
        .getContext('2d')!
        .getImageData(0, 0, 128, 128)
        .data.some((value) => value > 0),
    ),
  );
  expect(await page.locator('.tile').count()).toBeGreaterThan(30);
});

it('takes a dropped picture of normals as a style and refuses a photo', async () => {
  await openStyles();
  const tilted = sphereMap(([x, y, z]) => unit([x, y + 0.8, z]));
  await drop(page, '#canvas', 'tilted.png', writePng(pixelsOfMap(tilted, 64)));
  await chosen('tilted');
  const before = await picture(page);
  const grey = { width: 32, height: 24, data: new Uint8Array(4 * 32 * 24).fill(90) };
  await drop(page, '.gallery', 'photo.png', writePng(grey));
  const alert = page.locator('[role=alert] .notice');
  await alert.waitFor();
  expect(await alert.innerText()).toContain('crop it');
  await page.keyboard.press('Escape');
  expect(await picture(page)).toBe(before);
});

it('puts the style on the next mesh too, here an open one, and leaves its boundary blank', async () => {
  await openStyles();
  await drop(page, '#canvas', 'bowl.obj', bowl());
  await page.waitForFunction(() => document.querySelector('.report small')?.textContent === '972 faces');
  await chosen('Octahedron');
  await page.locator('.measures summary').click();
  await page.getByLabel('Curvature after').check({ force: true });
  expect(await page.locator('.legend .blank').innerText()).toContain('boundary');
});

it('reads a concave mesh through the sphere once asked, and says why another cannot be', async () => {
  await openStyles();
  await drop(page, '.gallery', 'peanut.obj', revolved(false));
  await act('accept-style').click();
  await page.waitForSelector('whittle-flow');
  await chosen('peanut');
  await drop(page, '.gallery', 'ring.obj', revolved(true));
  await act('accept-style').click();
  const alert = page.locator('[role=alert] .notice');
  await alert.waitFor();
  expect(await alert.innerText()).toMatch(/handle|genus/);
});

it('paints a stroke live, one entry, and saves the ball as a picture', async () => {
  await openStyles();
  await act('paint').click();
  const before = await picture(page);
  const box = (await page.locator('.ball').boundingBox())!;
  await page.mouse.move(box.x + 60, box.y + 60);
  await page.mouse.down();
  for (let step = 1; step <= 4; step++) await page.mouse.move(box.x + 60 + 10 * step, box.y + 60 + 6 * step);
  await page.mouse.up();
  await page.waitForFunction(() =>
    document.querySelector('[data-act=undo]')?.getAttribute('aria-label')?.includes('Stroke'),
  );
  await carved(page);
  expect(await picture(page)).not.toBe(before);
  expect(isPng((await saved(page, () => act('save-capture').click())).bytes)).toBe(true);
  await page.keyboard.press('Control+z');
  expect(await undoLabel()).toBe('Undo Octahedron');
  expect(await picture(page)).toBe(before);
});

it('colours the mesh by what it measures and says what the colours mean', async () => {
  await openStyles();
  const clay = await picture(page);
  await page.locator('.measures summary').click();
  await page.getByLabel('Angle before').check({ force: true });
  const mean = () =>
    page
      .locator('.legend')
      .innerText()
      .then((text) => Number(/average ([\d.]+)/.exec(text)![1]));
  const before = await mean();
  await page.getByLabel('Angle after').check({ force: true });
  expect(await mean()).toBeLessThan(before);
  expect(await picture(page)).not.toBe(clay);
  const angles = await picture(page);
  await page.getByLabel('Curvature after').check({ force: true });
  const ticks = () => page.locator('.legend .tick').allInnerTexts();
  expect(await ticks()).toEqual([
    expect.stringMatching(/^−\d/),
    '0',
    expect.stringMatching(/^\d+ × a ball’s$/),
  ]);
  expect(await page.locator('.measures figcaption').first().innerText()).toMatch(
    /flat.*% .* before, .*% after/s,
  );
  expect(await picture(page)).not.toBe(angles);
  await page.keyboard.down('b');
  expect(await page.locator('.legend b').innerText()).toBe('Gaussian curvature, before');
  await page.keyboard.up('b');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  expect(await page.getByLabel('Size', { exact: true }).isChecked()).toBe(true);
  expect((await ticks())[1]).toBe('×1');
  expect(await page.getByLabel('Strength', { exact: true }).and(page.locator('[name=overlay]')).count()).toBe(
    0,
  );
  await page.getByLabel('Nothing').check({ force: true });
  expect(await page.locator('.legend').count()).toBe(0);
  expect(await picture(page)).toBe(clay);
});

describe.runIf(canEmulate).each([
  ['in light', { colorScheme: 'light' }],
  ['in dark', { colorScheme: 'dark' }],
  ['on a phone', phone],
] as const)('%s', (_, options) => {
  it('passes axe with the gallery, the painter and the measures open', async () => {
    await openStyles(options);
    expect(await violations(page)).toEqual([]);
    await act('paint').click();
    for (const summary of await page.locator('details > summary').all()) await summary.click();
    for (const measure of ['Angle after', 'Curvature after']) {
      await page.locator('.chips label', { hasText: measure }).click();
      expect(await violations(page)).toEqual([]);
    }
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
  });
});

/** A half ball, open at the top, as OBJ. */
function bowl(): Uint8Array {
  const [around, along] = [36, 14];
  const lines: string[] = [];
  for (let j = 0; j < along; j++)
    for (let i = 0; i < around; i++) {
      const [turn, down] = [(2 * Math.PI * i) / around, (Math.PI / 2) * ((j + 1) / along)];
      const radius = Math.sin(down);
      lines.push(`v ${radius * Math.cos(turn)} ${-Math.cos(down)} ${radius * Math.sin(turn)}`);
    }
  lines.push('v 0 -1 0');
  const at = (i: number, j: number) => j * around + (i % around) + 1;
  for (let i = 0; i < around; i++) {
    lines.push(`f ${around * along + 1} ${at(i, 0)} ${at(i + 1, 0)}`);
    for (let j = 0; j + 1 < along; j++)
      lines.push(`f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)} ${at(i + 1, j)}`);
  }
  return new TextEncoder().encode(lines.join('\n'));
}

/** A waisted bottle without a hole, or a ring with one, as OBJ. */
function revolved(isRing: boolean): Uint8Array {
  const [around, along] = [32, 24];
  const lines: string[] = [];
  for (let i = 0; i < around; i++)
    for (let j = 0; j < along; j++) {
      const turn = (2 * Math.PI * i) / around;
      const t = isRing ? (2 * Math.PI * j) / along : (Math.PI * (j + 0.5)) / along;
      const waist = 0.6 + 0.4 * Math.cos(t) ** 2;
      const [radius, y] = isRing
        ? [1 + 0.4 * Math.cos(t), 0.4 * Math.sin(t)]
        : [waist * Math.sin(t), waist * Math.cos(t)];
      lines.push(`v ${radius * Math.cos(turn)} ${y} ${radius * Math.sin(turn)}`);
    }
  const at = (i: number, j: number) => (i % around) * along + (j % along) + 1;
  for (let i = 0; i < around; i++)
    for (let j = 0; j < (isRing ? along : along - 1); j++)
      lines.push(`f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)} ${at(i + 1, j)}`);
  if (!isRing) {
    const rim = (j: number) => Array.from({ length: around }, (_, i) => at(i, j));
    lines.push('v 0 1 0', 'v 0 -1 0');
    const [top, foot] = [around * along + 1, around * along + 2];
    for (let i = 0; i < around; i++) {
      lines.push(`f ${top} ${rim(0)[i]} ${rim(0)[(i + 1) % around]}`);
      lines.push(`f ${foot} ${rim(along - 1)[(i + 1) % around]} ${rim(along - 1)[i]}`);
    }
  }
  return new TextEncoder().encode(lines.join('\n'));
}
