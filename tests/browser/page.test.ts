import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import {
  carved,
  killWorker,
  lambda,
  picture,
  solveForever,
  solvingInWorker,
  status,
} from './support/browser.ts';
import { saved } from './support/downloads.ts';
import { usePage } from './support/use-page.ts';

const cube = `# by hand
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;

const pages = usePage();
let page: Page;

const open = async () => {
  page = await pages.open();
};
const act = (name: string) => page.locator(`[data-act=${name}]`);

async function drop(...files: { name: string; text: string }[]): Promise<void> {
  const transfer = await page.evaluateHandle((list) => {
    const data = new DataTransfer();
    for (const { name, text } of list) data.items.add(new File([text], name));
    return data;
  }, files);
  await page.dispatchEvent('#canvas', 'dragenter', { dataTransfer: transfer });
  expect(await page.locator('.drop').isVisible()).toBe(true);
  await page.dispatchEvent('#canvas', 'drop', { dataTransfer: transfer });
}

it('opens with a real mesh already carved, and then rests', async () => {
  await open();
  const carvedPicture = await picture(page);
  await page.keyboard.down('b');
  const original = await picture(page);
  await page.keyboard.up('b');
  expect(original).not.toBe(carvedPicture);
  expect(await picture(page)).toBe(carvedPicture);
  expect(await page.locator('.notice').count()).toBe(0);
});

it('follows the slider, is one undo entry a drag, and undoes and redoes the shape', async () => {
  await open();
  const [start, before] = [await lambda(page), await picture(page)];
  const box = (await page.locator('input[type=range]').boundingBox())!;
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 116, y);
  await page.mouse.down();
  for (let x = 120; x <= 240; x += 20) await page.mouse.move(box.x + x, y);
  await page.waitForFunction(() =>
    document.querySelector('whittle-status .sentence')?.textContent?.startsWith('Carv'),
  );
  await page.mouse.up();
  await carved(page);
  const after = await picture(page);
  expect(await lambda(page)).toBeGreaterThan(start);
  expect(after).not.toBe(before);
  await page.keyboard.press('Control+z');
  expect(await lambda(page)).toBe(start);
  expect(await picture(page)).toBe(before);
  expect(await act('undo').isDisabled()).toBe(true);
  await page.keyboard.press('Control+Shift+z');
  expect(await picture(page)).toBe(after);
});

it('takes a held arrow key for one gesture', async () => {
  await open();
  const start = await lambda(page);
  await page.locator('input[type=range]').focus();
  for (let press = 0; press < 5; press++) await page.keyboard.down('ArrowRight');
  await page.keyboard.up('ArrowRight');
  await carved(page);
  expect(await lambda(page)).toBeGreaterThan(start);
  await act('undo').click();
  expect(await lambda(page)).toBe(start);
  expect(await act('undo').isDisabled()).toBe(true);
});

it('stops on Escape and keeps what there is', async () => {
  await open();
  await solveForever(page);
  await page.keyboard.press('Escape');
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>('whittle-status')?.dataset.activity === 'idle',
  );
  expect(await status(page)).toMatch(/^Stopped after \d+ iterations/);
});

it('takes a dropped mesh and says what it left out', async () => {
  await open();
  await drop({ name: 'cube.mtl', text: '' }, { name: 'cube.obj', text: cube });
  await page.waitForSelector('.notice');
  expect(await page.locator('.notice').innerText()).toMatch(/textures/);
  await carved(page);
  expect(await page.locator('.report summary').innerText()).toContain('12 faces');
});

it('refuses a broken file in a sentence and keeps the mesh', async () => {
  await open();
  const before = await picture(page);
  await drop({ name: 'broken.obj', text: 'v 0 0 0\nf 1 x 3\n' });
  const alert = page.locator('[role=alert] .notice');
  await alert.waitFor();
  expect((await alert.innerText()).length).toBeGreaterThan(20);
  await page.keyboard.press('Escape');
  expect(await alert.count()).toBe(0);
  expect(await picture(page)).toBe(before);
});

it('gives the file back with the same face lines', async () => {
  await open();
  await drop({ name: 'cube.obj', text: cube });
  await page.waitForFunction(() =>
    document.querySelector('.report summary')?.textContent?.includes('12 faces'),
  );
  await carved(page);
  const { name, bytes } = await saved(page, () => page.keyboard.press('e'));
  expect(name).toBe('cube-cubic.obj');
  const faces = (text: string) => text.split('\n').filter((line) => line.startsWith('f '));
  expect(faces(bytes.toString())).toEqual(faces(cube));
});

it('saves a picture', async () => {
  await open();
  const { bytes } = await saved(page, () => act('picture').click());
  expect(bytes.toString('latin1', 1, 4)).toBe('PNG');
  expect(bytes.length).toBeGreaterThan(20_000);
});

it('survives one death of the worker unnoticed and offers a retry after the second', async () => {
  await open();
  await solveForever(page);
  await killWorker(page);
  await solvingInWorker(page, 2);
  expect(await page.locator('.notice').count()).toBe(0);
  await killWorker(page);
  await act('again').click();
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>('whittle-status')?.dataset.activity === 'solving',
  );
  await page.keyboard.press('Escape');
});

it('changes shading and opens samples from the keyboard', async () => {
  await open();
  const smooth = await picture(page);
  await page.keyboard.press('3');
  expect(await picture(page)).not.toBe(smooth);
  await page.locator('whittle-topbar .menu-button').focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() =>
    document.querySelector('[data-act=undo]')?.getAttribute('aria-label')?.includes('suzanne'),
  );
  await carved(page);
  expect(await page.locator('[data-act=undo]').getAttribute('aria-label')).toBe('Undo Open suzanne.glb');
});

it('does not draw while nothing changes', async () => {
  await open();
  // Glides and thumbnails end by themselves; then nobody asks for a frame any more, however long one waits.
  const asked = await page.evaluate(async () => {
    let calls = 0;
    const real = globalThis.requestAnimationFrame;
    globalThis.requestAnimationFrame = (callback) => {
      calls++;
      return real(callback);
    };
    const pause = () => new Promise((resolve) => setTimeout(resolve, 400));
    for (let before = -1; before !== calls; ) {
      before = calls;
      await pause();
    }
    const atRest = calls;
    await pause();
    return calls - atRest;
  });
  expect(asked).toBe(0);
});
