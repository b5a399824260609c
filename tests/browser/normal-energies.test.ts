import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { carved, entered, picture } from './support/browser.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

const shading = () => page.locator('input[name=shading]:checked').inputValue();

/** Takes a method and waits for its own result. The entry has the name of what the method starts with, if it starts with something. */
async function choose(title: string, entry = title): Promise<void> {
  await page.locator('.switch').getByText(title, { exact: true }).click();
  await entered(page, entry);
}

it('makes boxes of a mesh, by the directions of a shape', async () => {
  page = await pages.open();
  const cubic = await picture(page);
  await choose('Blocks', 'Cube');
  expect(await page.locator('.tile[aria-selected=true]').getAttribute('title')).toBe('Cube');
  expect(await page.locator('.tile[data-style^=meshes]').count()).toBe(0);
  expect(await page.locator('[data-act=paint]').count()).toBe(0);
  expect(await shading()).toBe('flat');
  const boxes = await picture(page);
  expect(boxes).not.toBe(cubic);
  await page.locator('[data-style=shapes-hexagonal-prism]').click();
  await page.waitForSelector('[data-style=shapes-hexagonal-prism][aria-selected=true]');
  await carved(page);
  expect(await picture(page)).not.toBe(boxes);
  await page.keyboard.press('Control+z');
  await page.waitForSelector('[data-style=shapes-cube][aria-selected=true]');
  expect(await picture(page)).toBe(boxes);
});

it('folds a mesh, and shades it by faces unless told otherwise', async () => {
  page = await pages.open();
  await choose('Paper');
  expect(await shading()).toBe('flat');
  const half = await picture(page);
  const range = page.getByLabel('Creases', { exact: true });
  await range.focus();
  await page.keyboard.press('Home');
  await entered(page, 'Creases');
  expect(await picture(page)).not.toBe(half);
  await choose('Cubic');
  expect(await shading()).toBe('smooth');
  await page.locator('input[name=shading][value=wire]').check({ force: true });
  await choose('Paper');
  expect(await shading()).toBe('wire');
});
