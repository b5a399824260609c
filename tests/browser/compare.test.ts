import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { done, drag, type Place, takeTool } from './support/hands.ts';
import { exported } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();

const names = (page: Page) =>
  page.locator('.compared').evaluateAll((all) => all.map((one) => (one as HTMLElement).ariaLabel));

/** What a picture shows below its name, at rest. */
async function shown(page: Page, index: number): Promise<string> {
  await page.waitForSelector('whittle-status[data-activity=idle]');
  await page.waitForFunction(() => !document.querySelector('.compared .pulse'));
  await picture(page);
  const box = (await page.locator('.compared').nth(index).boundingBox())!;
  const shot = await page.screenshot({
    clip: { x: box.x + 20, y: box.y + 50, width: box.width - 40, height: box.height - 90 },
  });
  return shot.toString('base64');
}

async function beside(page: Page): Promise<void> {
  await page.locator('.switch').getByText('Pose', { exact: true }).click();
  await done(page, 'Pose');
  await page.keyboard.press('n');
  await page.waitForSelector('.compared >> nth=1');
}

it('shows two choices side by side: one gesture drives both, one hand turns both, and only what is used is kept', async () => {
  const page = await pages.open();
  await takeTool(page, 'Move');
  await beside(page);
  expect(await names(page)).toEqual(['Soft', 'Crisp']);
  const before = await shown(page, 1);

  const first = (await page.locator('.compared').nth(0).boundingBox())!;
  const flank: Place = [first.x + first.width / 2, first.y + first.height / 2 + 20];
  await drag(page, flank, [flank[0] + 30, flank[1] - 40], [flank[0] + 50, flank[1] - 60]);
  await done(page, 'Pull');
  const pulled = [await shown(page, 0), await shown(page, 1)];
  expect(pulled[1]).not.toBe(before);

  // Beside the shape of the second picture, which no tool works in, the view is turned.
  const second = (await page.locator('.compared').nth(1).boundingBox())!;
  const corner: Place = [second.x + 60, second.y + 150];
  await drag(page, corner, [corner[0] + 90, corner[1]]);
  expect(await shown(page, 0)).not.toBe(pulled[0]);
  expect(await page.locator('[data-act=undo]').getAttribute('aria-label')).toBe('Undo Pull');

  await page.mouse.click(second.x + second.width / 2, second.y + second.height / 2);
  await done(page, 'Edges');
  expect(await names(page)).toEqual(['Crisp', 'Soft']);
  const { bytes } = await exported(page, 'Recipe');
  expect(JSON.parse(bytes.toString()).steps[0].regularizer).toBe('farap');

  // The first lets the group go that the tool has in hand.
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.querySelectorAll('.compared').length === 0);
  await page.keyboard.press('Control+z');
  await done(page, 'Pull');
});

it('compares up to as many as there are, by keys alone, and can be read by all', async () => {
  const page = await pages.open({ colorScheme: 'dark' });
  await beside(page);
  await page.locator('[data-act=compare-more]').press('Enter');
  await page.waitForSelector('.compared >> nth=2');
  expect(await names(page)).toEqual(['Soft', 'Crisp', 'Elastic']);
  expect(await page.locator('[data-act=compare-more]').count()).toBe(0);
  expect(await violations(page)).toEqual([]);
  await page.getByRole('button', { name: 'Use Elastic' }).press('Enter');
  await done(page, 'Edges');
  expect(await names(page)).toEqual(['Elastic', 'Crisp', 'Soft']);
  await page.getByRole('button', { name: 'Take Soft away' }).press('Enter');
  await page.getByRole('button', { name: 'Take Crisp away' }).press('Enter');
  expect(await page.locator('.compared').count()).toBe(0);
  // Another method has other choices.
  await page.keyboard.press('n');
  await page.waitForSelector('.compared >> nth=1');
  await page.locator('.switch').getByText('Reshape', { exact: true }).click();
  await done(page, 'Reshape');
  expect(await page.locator('.compared').count()).toBe(0);
  // What cannot be compared by anything offers nothing.
  await page.locator('.switch').getByText('Cubic', { exact: true }).click();
  await done(page, 'Cubic');
  expect(await page.locator('[data-act=beside]').count()).toBe(0);
});

it.runIf(canEmulate)('stands one above the other on a phone', async () => {
  const page = await pages.open({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    deviceScaleFactor: 1,
  });
  await page.locator('.switch').getByText('Pose', { exact: true }).tap();
  await done(page, 'Pose');
  await page.locator('[data-act=beside]').tap();
  await page.waitForSelector('.compared >> nth=1');
  const [first, second] = await Promise.all(
    [0, 1].map((k) => page.locator('.compared').nth(k).boundingBox()),
  );
  expect(second!.y).toBeGreaterThanOrEqual(first!.y + first!.height);
  expect(await page.locator('[data-act=compare-more]').count()).toBe(0);
  expect(await violations(page)).toEqual([]);
  await page.touchscreen.tap(second!.x + second!.width / 2, second!.y + second!.height / 2);
  await done(page, 'Edges');
  expect(await names(page)).toEqual(['Crisp', 'Soft']);
});
