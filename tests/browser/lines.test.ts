import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { block } from '../fixtures/hard-edged.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { violations } from './support/axe.ts';
import { carved, drop } from './support/browser.ts';
import { browserName } from './support/connect.ts';
import { done, type Place, takeTool } from './support/hands.ts';
import { exported } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** From −4 to 4 along x, from −1 to 1 else. */
const bar = block(6);
bar.positions.forEach((x, k) => {
  if (k % 3 === 0) bar.positions[k] = 4 * x;
});

/** The edge of the bar at its top behind, and an edge across its front, as they are seen at first. */
const behind: Place = [600, 336];
const across: Place = [492, 420];

interface Marked {
  readonly features?: number[][];
  readonly smooth?: number[][];
  readonly straight?: number[][];
}

async function marked(): Promise<Marked> {
  const { bytes } = await exported(page, 'Recipe');
  return JSON.parse(bytes.toString()).steps[0];
}

/** Waits until a click there would do what is expected. A hand is never quite still: after a click elsewhere Firefox may report its place once more, which takes the sentence of a single move away. */
async function pointed([x, y]: Place, sentence: RegExp): Promise<void> {
  const said = page.locator('.pointed').filter({ hasText: sentence });
  for (let nudge = 0; (await said.count()) === 0; nudge = 1 - nudge) {
    await page.mouse.move(x + nudge, y);
    await page.waitForTimeout(100);
  }
}

const role = (name: string) => page.locator(`[data-role=${name}]`).click();

beforeEach(async () => {
  page = await pages.open();
  await drop(page, '#stage', 'bar.obj', Buffer.from(objText(bar)));
  await page.getByRole('button', { name: /Export OBJ/ }).waitFor();
  await carved(page);
  await page.locator('.switch').getByText('Reshape', { exact: true }).click();
  await done(page, 'Reshape');
  await takeTool(page, 'Lines');
});

it('marks the whole line that is pointed at, and takes the mark away again, each an entry for undo', async () => {
  await role('smooth');
  await pointed(behind, /marks a line of 6 edges/);
  await page.mouse.click(...behind);
  await done(page, 'Mark no creases');
  const { smooth } = await marked();
  expect(smooth).toHaveLength(1);
  expect(smooth![0]!.map((v) => [...bar.positions.subarray(3 * v + 1, 3 * v + 3)])).toEqual(
    Array.from({ length: 7 }, () => [1, -1]),
  );
  // What is a crease is not smooth any more.
  await role('crease');
  await page.mouse.click(...behind);
  await done(page, 'Mark creases');
  const both = await marked();
  expect([both.smooth, both.features?.length]).toEqual([undefined, 1]);
  await pointed(behind, /takes the mark from a line of 6/);
  await page.mouse.click(...behind);
  await done(page, 'Unmark creases');
  expect((await marked()).features).toBeUndefined();
  await page.keyboard.press('Control+z');
  await done(page, 'Mark creases');
  expect(await marked()).toEqual(both);
});

it('marks lines across a side as straight, by keys; Alt only takes away; and passes axe', async () => {
  await role('straight');
  await pointed(across, /marks a line of 6 edges/);
  await page.keyboard.down('Alt');
  await page.mouse.click(...across);
  await page.keyboard.up('Alt');
  await page.locator('#canvas').focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await done(page, 'Mark straight lines');
  const { straight } = await marked();
  expect(straight).toHaveLength(1);
  expect(straight![0]!.length).toBeGreaterThan(2);
  expect(await page.locator('.marked-lines').innerText()).toBe('Straight lines: 1 line');
  expect(await violations(page)).toEqual([]);
  const clear = page.locator('[data-clear=straight]');
  // The page has lost the focus to the export in Firefox, where a script cannot give it back, and keys press no button.
  await (browserName === 'firefox' ? clear.click() : clear.press('Enter'));
  await done(page, 'Unmark straight lines');
  expect(await page.locator('.marked-lines').count()).toBe(0);
});
