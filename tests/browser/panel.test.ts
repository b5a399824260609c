import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { violations } from './support/axe.ts';
import { carved, entered } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { usePage } from './support/use-page.ts';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const pages = usePage();
let page: Page;

const act = (name: string) => page.locator(`[data-act=${name}]`);

/** The method that is on, and what its picture is like. */
const chosen = () => page.locator('.switch label:has(:checked)');

it('offers methods as pictures by what a person wants, each with its sentence, from the keyboard too', async () => {
  page = await pages.open();
  const groups = await page
    .locator('.intent')
    .evaluateAll((all) =>
      all.map((group) => [
        group.getAttribute('aria-label'),
        ...[...group.querySelectorAll('label')].map((label) => label.textContent?.trim()),
      ]),
    );
  expect(groups).toEqual([
    ['Carve', 'Cubic', 'Style', 'Blocks', 'Relief'],
    ['Fold', 'Paper'],
    ['Move', 'Reshape', 'Pose'],
  ]);
  const pictures = page.locator('.switch img');
  await page.waitForFunction(() =>
    [...document.querySelectorAll<HTMLImageElement>('.switch img')].every(({ complete }) => complete),
  );
  expect(
    await pictures.evaluateAll((all) => all.map((one) => (one as HTMLImageElement).naturalWidth)),
  ).toEqual(Array(7).fill(104));
  await page.locator('.switch input').nth(1).focus();
  await page.keyboard.press('ArrowRight');
  await entered(page, 'Cube');
  expect(await chosen().innerText()).toContain('Blocks');
  expect(await page.locator('.summary').innerText()).toContain('a mesh of boxes');
});

it.runIf(canEmulate).each([
  ['on a desk', {}],
  ['on a phone', phone],
] as const)('keeps Export in reach %s, in one scroll', async (_, options) => {
  page = await pages.open({ ...options, deviceScaleFactor: 1 });
  await page.locator('.switch label').nth(1).click();
  await entered(page, 'Octahedron');
  if (await act('all-styles').isVisible()) await act('all-styles').click();
  const box = (await page.locator('.sheet').boundingBox())!;
  for (const share of [0, 0.5, 1]) {
    await page.locator('.settings').evaluate((sheet, at) => {
      sheet.scrollTop = at * sheet.scrollHeight;
    }, share);
    const button = (await act('export').boundingBox())!;
    expect(button.y).toBeGreaterThan(box.y);
    expect(button.y + button.height).toBeLessThanOrEqual(box.y + box.height);
  }
  const scrollers = await page
    .locator('.settings *')
    .evaluateAll(
      (all) =>
        all.filter(
          (one) => one.scrollHeight > one.clientHeight + 1 && getComputedStyle(one).overflowY === 'auto',
        ).length,
    );
  expect(scrollers).toBe(0);
});

it.runIf(canEmulate)(
  'on a phone scrolls no way but down, and no tool lies under the buttons of the view',
  async () => {
    page = await pages.open(phone);
    // The last picture, with the most tools.
    await page.locator('.switch label').getByText('Reshape', { exact: true }).click();
    await page.waitForSelector('.strip label >> text=Lines');
    const sideways = await page
      .locator('.settings')
      .evaluate(({ scrollLeft, scrollWidth, clientWidth }) => [scrollLeft, scrollWidth - clientWidth]);
    expect(sideways).toEqual([0, 0]);
    const [strip, bar] = await Promise.all(
      ['.strip', 'whittle-viewbar'].map((one) => page.locator(one).boundingBox()),
    );
    expect(strip!.y + strip!.height).toBeLessThanOrEqual(bar!.y);
  },
);

it('folds the solver away, and says of each setting what it does', async () => {
  page = await pages.open();
  expect(await page.locator('.solver whittle-parameter').first().isVisible()).toBe(false);
  await page.locator('.solver summary').click();
  const settings = page.locator('.solver whittle-parameter');
  for (const setting of await settings.all()) {
    expect((await setting.locator('.explained').innerText()).length).toBeGreaterThan(20);
  }
  await page.getByText('energy', { exact: true }).click();
  await entered(page, 'Stop by');
  expect(await page.getByRole('radio', { name: 'energy' }).isChecked()).toBe(true);
});

it('gives a hint until something was done or it was read, and never again', async () => {
  page = await pages.open();
  expect(await page.locator('.hint').innerText()).toContain('slider');
  await page.locator('input[type=range]').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.locator('.hint').waitFor({ state: 'detached' });
  await carved(page);
  await page.locator('.strip label').nth(1).click();
  const other = await page.locator('.hint').innerText();
  await act('got-it').click();
  await page.locator('.hint').waitFor({ state: 'detached' });
  await page.reload();
  await carved(page);
  expect(await page.locator('.hint').count()).toBe(0);
  await page.locator('.strip label').nth(1).click();
  expect(other.length).toBeGreaterThan(20);
  expect(await page.locator('.hint').count()).toBe(0);
});

it.runIf(canEmulate).each([
  ['by day', {}],
  ['in the dark', { colorScheme: 'dark' }],
  ['on a phone', phone],
] as const)('passes axe %s, with the solver open and with the help', async (_, options) => {
  page = await pages.open(options);
  await page.locator('.solver summary').click();
  expect(await violations(page)).toEqual([]);
  await act('help').click();
  expect(await page.locator('.help-methods b').allInnerTexts()).toEqual([
    'Cubic',
    'Style',
    'Blocks',
    'Relief',
    'Paper',
    'Reshape',
    'Pose',
  ]);
  expect(await violations(page)).toEqual([]);
});
