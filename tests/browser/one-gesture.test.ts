import { expect, it } from 'vitest';
import { picture } from './support/browser.ts';
import { done, drag, type Place, takeTool } from './support/hands.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();

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

it.each(gestures)(
  '$entry is one entry of undo, and leaves nothing',
  async ({ tool, press, entry, places }) => {
    const page = await pages.open();
    await takeTool(page, tool);
    if (press) await page.getByRole('button', { name: press, exact: true }).click();
    await page.mouse.move(20, 780);
    const before = await picture(page);
    await drag(page, ...places);
    await done(page, entry);
    await page.mouse.move(20, 780);
    expect(await picture(page)).not.toBe(before);
    await page.keyboard.press('Control+z');
    await page.waitForSelector('[data-act=undo]:disabled');
    await page.waitForSelector('whittle-status[data-activity=idle]');
    expect(await picture(page)).toBe(before);
  },
);
