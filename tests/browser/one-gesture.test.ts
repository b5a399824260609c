import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { done, drag, type Place, takeTool } from './support/hands.ts';
import { exported } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();

/** What is exported, as a text to be compared. */
const shape = async (page: Page) => (await exported(page, 'glTF binary')).bytes.toString('base64');

/** On the rabbit as it opens, in a window of 1200×800, through several places each. */
const gestures: readonly { tool: string; press?: string; entry: string; places: readonly Place[] }[] = [
  {
    tool: 'Move',
    entry: 'Pull',
    places: [
      [560, 290],
      [580, 230],
      [560, 200],
      [600, 180],
    ],
  },
  {
    tool: 'Move',
    press: 'Hold',
    entry: 'Hold',
    places: [
      [560, 500],
      [600, 520],
      [640, 500],
    ],
  },
  {
    tool: 'Paint',
    entry: 'Paint strength',
    places: [
      [640, 430],
      [620, 400],
      [560, 500],
    ],
  },
  {
    tool: 'Cube',
    entry: 'Stretch the cube',
    places: [
      [593, 195],
      [593, 160],
      [593, 120],
    ],
  },
  {
    tool: 'Cube',
    entry: 'Turn the cube',
    places: [
      [593, 433],
      [630, 436],
      [670, 436],
    ],
  },
];

it.each(gestures)('$entry is one entry of undo, there and back', async ({ tool, press, entry, places }) => {
  const page = await pages.open();
  await takeTool(page, tool);
  if (press) await page.getByRole('button', { name: press, exact: true }).click();
  const before = await shape(page);
  await drag(page, ...places);
  await done(page, entry);
  const after = await shape(page);
  await page.keyboard.press('Control+z');
  await page.waitForSelector('[data-act=undo]:disabled');
  expect(await shape(page)).toBe(before);
  await page.keyboard.press('Control+Shift+z');
  await done(page, entry);
  expect(await shape(page)).toBe(after);
});
