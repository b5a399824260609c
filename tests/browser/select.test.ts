import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { block } from '../fixtures/hard-edged.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { violations } from './support/axe.ts';
import { carved, drop, picture } from './support/browser.ts';
import { canEmulate } from './support/connect.ts';
import { saved } from './support/downloads.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();

/** A block of 12² squares a side, which the first method leaves as it is; the tool that selects is in the hand. */
async function openBlock(options: Parameters<typeof pages.open>[0] = {}): Promise<Page> {
  const page = await pages.open(options);
  await drop(page, '#stage', 'block.obj', Buffer.from(objText(block(12))));
  await page.getByRole('button', { name: /Export OBJ/ }).waitFor();
  await carved(page);
  await page.keyboard.press('q');
  // The view makes room for the options.
  await picture(page);
  return page;
}

/** Of “169 of 866 vertices are selected.”, or of “All 866 …”. */
const countIn = (sentence: string) => Number(/\d+/.exec(sentence)?.[0]);

const said = (page: Page) => page.locator('.tool-options .selected').innerText();

async function selected(page: Page, sentence: RegExp | string): Promise<void> {
  await page.locator('.tool-options .selected').filter({ hasText: sentence }).waitFor();
}

/** Hovers until the tool says that a click there takes what is meant: the tree of boxes is made beside. */
async function pointed(page: Page, [x, y]: readonly [number, number], sentence: RegExp): Promise<void> {
  const line = page.locator('.tool-options .pointed');
  for (let nudge = 0; !sentence.test(await line.innerText()); nudge = 1 - nudge)
    await page.mouse.move(x + nudge / 2, y);
}

/** Goes from place to place with the first button down. */
async function dragged(page: Page, ...places: (readonly [number, number])[]): Promise<void> {
  await page.mouse.move(...places[0]!);
  await page.mouse.down();
  for (const [x, y] of places.slice(1)) await page.mouse.move(x, y, { steps: 8 });
  await page.mouse.up();
}

// Places on the window where the sides of the block are seen from the first view.
const right = [770, 480] as const;
const front = [540, 480] as const;
const top = [580, 262] as const;

describe('selecting by pointing', () => {
  it('takes what it says that it takes; Shift adds, Ctrl takes away, Alt takes a vertex, twice the whole part, Escape nothing', async () => {
    const page = await openBlock();
    await pointed(page, right, /^A click takes a smooth patch of 169 vertices\.$/);
    await page.mouse.click(...right);
    await selected(page, '169 of 866 vertices are selected.');
    await page.keyboard.down('Shift');
    await page.mouse.click(...front);
    await selected(page, '325 of 866');
    await page.keyboard.up('Shift');
    await page.keyboard.down('Control');
    await page.mouse.click(...right);
    await page.keyboard.up('Control');
    await selected(page, '156 of 866');
    await page.keyboard.down('Alt');
    await page.mouse.click(...top);
    await page.keyboard.up('Alt');
    await selected(page, '1 of 866 vertices is selected.');
    await page.mouse.dblclick(...front);
    await selected(page, 'All 866 vertices are selected.');
    await page.keyboard.press('Escape');
    await selected(page, 'Nothing is selected.');
  });

  it('takes an edge from corner to corner where the pointer is near it', async () => {
    const page = await openBlock();
    await pointed(page, right, /smooth patch/);
    // Along a line across the edge between front and right.
    let line = '';
    for (let x = 640; x < 740 && !/an edge/.test(line); x += 3) {
      await page.mouse.move(x, 480);
      line = await page.locator('.tool-options .pointed').innerText();
    }
    expect(line).toBe('A click takes an edge, 13 vertices.');
  });

  it('turns the view where a drag begins beside the mesh', async () => {
    const page = await openBlock();
    await pointed(page, right, /smooth patch/);
    await page.mouse.move(840, 690);
    const before = await picture(page);
    await dragged(page, [840, 690], [700, 740]);
    expect(await picture(page)).not.toBe(before);
    expect(await said(page)).toBe('Nothing is selected.');
  });
});

describe('selecting by drawing', () => {
  it('takes what a frame holds: the side that is seen, or the far side too', async () => {
    const page = await openBlock();
    await pointed(page, right, /smooth patch/);
    await page.locator('.choice').getByText('Frame').click();
    await dragged(page, [330, 90], [858, 720]);
    await selected(page, /of 866/);
    const seen = countIn(await said(page));
    await page.getByLabel('Far side too').check();
    await dragged(page, [330, 90], [858, 720]);
    await page.waitForFunction(
      (before) => !document.querySelector('.selected')!.textContent!.startsWith(`${before} `),
      seen,
    );
    expect(countIn(await said(page))).toBeGreaterThan(seen + 100);
  });

  it('takes what a lasso goes around, and a stroke of the brush; Escape takes the gesture back', async () => {
    const page = await openBlock();
    await pointed(page, right, /smooth patch/);
    await page.locator('.choice').getByText('Lasso').click();
    await dragged(page, [722, 400], [802, 400], [802, 520], [722, 520]);
    await selected(page, /of 866 vertices are selected/);
    const inside = countIn(await said(page));
    expect(inside).toBeGreaterThan(8);
    expect(inside).toBeLessThan(100);
    await page.locator('.choice').getByText('Brush').click();
    await page.mouse.move(500, 400);
    await page.mouse.down();
    await page.mouse.move(580, 600, { steps: 12 });
    await page.waitForFunction(
      (count) => !document.querySelector('.selected')!.textContent!.startsWith(`${count} `),
      inside,
    );
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await selected(page, `${inside} of 866`);
    await dragged(page, [500, 400], [580, 600]);
    await page.waitForFunction(
      (count) => !document.querySelector('.selected')!.textContent!.startsWith(`${count} `),
      inside,
    );
    expect(await page.locator('[data-act=undo]').isDisabled()).toBe(false);
  });
});

describe('groups', () => {
  it('are named, taken, renamed and undone from the keyboard, and stay in the recipe', async () => {
    const page = await openBlock();
    await pointed(page, right, /smooth patch/);
    await page.mouse.click(...right);
    await selected(page, '169');
    await page.getByLabel('Name for what is selected').focus();
    await page.keyboard.type('right side');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: /^right side/ }).waitFor();
    await page.keyboard.press('Escape');
    await selected(page, 'Nothing');
    await page.getByRole('button', { name: /^right side/ }).focus();
    await page.keyboard.press('Enter');
    await selected(page, '169');
    await page.getByRole('button', { name: 'Rename “right side”' }).focus();
    await page.keyboard.press('Enter');
    await page.keyboard.type('cheek');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: /^cheek/ }).waitFor();

    const recipe = await saved(page, async () => {
      await page.getByRole('button', { name: 'Other ways to export' }).click();
      await page.getByRole('menuitem', { name: /^Recipe/ }).click();
    });
    const { groups } = JSON.parse(recipe.bytes.toString());
    expect(groups).toHaveLength(1);
    expect(groups[0].name).toBe('cheek');
    expect(groups[0].vertices).toHaveLength(169);

    await page.locator('[data-act=undo]').click();
    await page.getByRole('button', { name: /^right side/ }).waitFor();
    await page.getByRole('button', { name: 'Forget “right side”' }).click();
    await page.locator('.named-groups').waitFor({ state: 'detached' });
    expect(await violations(page)).toEqual([]);
  });
});

it('works from the keyboard alone: the arrow keys walk a cross, Enter takes what is under it', async () => {
  const page = await openBlock();
  await pointed(page, right, /smooth patch/);
  await page.mouse.move(10, 790);
  await page.locator('#canvas').focus();
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowLeft');
  await page.locator('.tool-options .pointed').filter({ hasText: 'smooth patch' }).waitFor();
  await page.keyboard.press('Enter');
  await selected(page, '169');
  await page.keyboard.press('.');
  await selected(page, '217');
  await page.keyboard.press(',');
  await selected(page, '169');
  await page.keyboard.press('i');
  await selected(page, '697');
});

it.runIf(canEmulate)('works with a finger: a switch stands in for Shift', async () => {
  const page = await openBlock({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.waitForSelector('.strip[aria-busy=false]');
  await selected(page, 'Nothing');
  await page.touchscreen.tap(295, 340);
  await selected(page, '169 of 866');
  await page.locator('.choice').getByText('Add').tap();
  await page.touchscreen.tap(150, 350);
  await selected(page, '325 of 866');
  expect(await violations(page)).toEqual([]);
});
