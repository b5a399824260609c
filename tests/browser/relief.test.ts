import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { bakedGlb, normalMap, plate, pngOf } from '../fixtures/textured.ts';
import { violations } from './support/axe.ts';
import { carved, drop, entered, picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { usePage } from './support/use-page.ts';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const pages = usePage();
let page: Page;

const relief = () => page.locator('.switch label', { hasText: 'Relief' });
const tile = (name: string) => page.locator('.images label', { hasText: name });

/** From the first sample, which has no texture coordinates, to a jar that carries a weave. */
async function openRelief(options = {}): Promise<void> {
  page = await pages.open(options);
  await relief().click();
  await page.getByRole('button', { name: 'Try the jar' }).click();
  await page.waitForSelector('.images');
  await carved(page);
}

async function chosen(name: string): Promise<void> {
  await page.waitForFunction(
    (wanted) =>
      document.querySelector('.images input:checked')?.closest('label')?.textContent?.trim() === wanted,
    name,
  );
  await carved(page);
}

it('says why a mesh has no relief and offers one that can; then a click is a relief, one entry each', async () => {
  page = await pages.open();
  await relief().click();
  const notice = page.locator('[role=status] .notice');
  expect(await notice.innerText()).toContain('this mesh has none');
  expect(await page.locator('.switch input').first().isChecked()).toBe(true);
  await page.getByRole('button', { name: 'Try the jar' }).click();
  await chosen('Weave');
  const woven = await picture(page);
  await tile('Scales').click();
  await entered(page, 'Scales');
  await chosen('Scales');
  expect(await picture(page)).not.toBe(woven);
  await page.keyboard.press('Control+z');
  await chosen('Weave');
  expect(await picture(page)).toBe(woven);
});

it('follows the strength, and without any the jar is as it came', async () => {
  await openRelief();
  const woven = await picture(page);
  await page.locator('#parameter-strength').focus();
  await page.keyboard.press('Home');
  await entered(page, 'Strength');
  const flat = await picture(page);
  expect(flat).not.toBe(woven);
  await page.keyboard.down('b');
  expect(await picture(page)).toBe(flat);
  await page.keyboard.up('b');
  await page.keyboard.press('Control+z');
  expect(await picture(page)).toBe(woven);
});

it('says when the picture is too fine for the mesh', async () => {
  await openRelief();
  expect(await page.locator('.remark').isVisible()).toBe(false);
  await page.locator('#parameter-repeat').focus();
  await page.keyboard.press('End');
  await page.waitForSelector('.remark:visible');
  expect(await page.locator('.remark').innerText()).toMatch(/finer than this mesh can show/);
});

it('takes a dropped normal map anywhere, a JPEG as height, and refuses what is no picture', async () => {
  await openRelief();
  await drop(
    page,
    '#canvas',
    'waves.png',
    pngOf(normalMap(64, (u, v) => 0.03 * Math.sin(12 * u) * Math.sin(12 * v))),
  );
  await entered(page, 'waves');
  await chosen('waves');
  // Only what is one's own can be read in several ways.
  await page.locator('.solver summary').click();
  const before = await picture(page);
  await page.getByLabel('Green points').selectOption('down');
  await entered(page, 'Green points');
  expect(await picture(page)).not.toBe(before);
  const jpeg = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(64, 64);
    const pen = canvas.getContext('2d')!;
    pen.fillRect(0, 0, 64, 64);
    pen.fillStyle = 'white';
    pen.fillRect(16, 16, 32, 32);
    const blob = await canvas.convertToBlob({ type: 'image/jpeg' });
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
  await drop(page, '.images', 'stamp.jpg', Uint8Array.from(jpeg));
  await chosen('stamp');
  await drop(page, '.images', 'fake.webp', Uint8Array.of(1, 2, 3));
  const alert = page.locator('[role=alert] .notice');
  await alert.waitFor();
  expect(await alert.innerText()).toContain('fake.webp could not be read as an image');
  await tile('Weave').click();
  await entered(page, 'Weave');
  await chosen('Weave');
  expect(await page.getByLabel('Green points').count()).toBe(0);
});

it('unbakes the normal map inside a file at the first click', async () => {
  await openRelief();
  const map = pngOf(normalMap(64, (u, v) => 0.02 * Math.sin(12 * u) * Math.sin(12 * v)));
  await drop(page, '#canvas', 'plate.glb', bakedGlb(plate(60), map));
  await page.waitForFunction(() => !document.querySelector('.images'));
  await carved(page);
  await relief().click();
  await page.waitForSelector('.images');
  await chosen('baked');
  expect(await page.locator('.images label').count()).toBe(4);
  expect(await page.locator('#parameter-repeat').getAttribute('aria-valuetext')).toBe('1');
});

it.runIf(canEmulate).each([
  ['in dark', { colorScheme: 'dark' }],
  ['on a phone', phone],
] as const)('passes axe %s', async (_, options) => {
  await openRelief(options);
  expect(await violations(page)).toEqual([]);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
});
