import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { block } from '../fixtures/hard-edged.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { violations } from './support/axe.ts';
import { carved, drop } from './support/browser.ts';
import { done, drag, type Place, takeTool } from './support/hands.ts';
import { exported } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** The end of a bar along x, which looks to the right, and its front, as they are seen at first. */
const end: Place = [830, 440];
const front: Place = [600, 420];

const groups = () => page.locator('.groups .group-name').allInnerTexts();

/** By vertex, from where and to where it is held. */
async function handles(): Promise<{ from: readonly number[]; to: readonly number[] }[]> {
  const { bytes } = await exported(page, 'Recipe');
  const { vertices, targets } = JSON.parse(bytes.toString()).steps[0].handles;
  return vertices.map((vertex: number, k: number) => ({
    from: [...bar.positions.subarray(3 * vertex, 3 * vertex + 3)],
    to: targets[k],
  }));
}

/** From −4 to 4 along x, from −1 to 1 else. */
const bar = block(6);
bar.positions.forEach((x, k) => {
  if (k % 3 === 0) bar.positions[k] = 4 * x;
});

beforeEach(async () => {
  page = await pages.open();
  await drop(page, '#stage', 'bar.obj', Buffer.from(objText(bar)));
  await page.getByRole('button', { name: /Export OBJ/ }).waitFor();
  await carved(page);
  await page.locator('.switch').getByText('Pose', { exact: true }).click();
  await done(page, 'Pose');
  await takeTool(page, 'Move');
  await page.locator('[data-take=side]').click();
});

it('takes the end of a bar with one press, pulls it straight out, and holds the other end', async () => {
  await drag(page, end, [860, 480], [890, 520]);
  await done(page, 'Pull');
  expect(await groups()).toEqual(['Moved', 'Base']);
  const all = await handles();
  expect(all).toHaveLength(2 * 49);
  const pulled = all.filter(({ from }) => from[0] === 4);
  expect(pulled).toHaveLength(49);
  const by = pulled[0]!.to[0]! - 4;
  expect(by).toBeGreaterThan(0.2);
  for (const { from, to } of pulled) {
    expect(to[0]).toBeCloseTo(4 + by, 9);
    expect(to.slice(1)).toEqual(from.slice(1));
  }
  for (const { from, to } of all.filter((one) => !pulled.includes(one))) {
    expect(from[0]).toBe(-4);
    expect(to).toEqual(from);
  }
});

it('takes hold of a side with a click, holds another still with Shift, and lets it go by a click', async () => {
  await page.keyboard.down('Shift');
  await page.mouse.click(...front);
  await page.keyboard.up('Shift');
  await done(page, 'Hold');
  expect(await groups()).toEqual(['Held']);
  expect(new Set((await handles()).map(({ from }) => from[2]))).toEqual(new Set([1]));
  await page.mouse.click(...end);
  await done(page, 'Take hold');
  expect(await groups()).toEqual(['Held', 'Moved']);
  expect((await handles()).every(({ from, to }) => from.every((x, k) => x === to[k]))).toBe(true);
  // Where it was clicked it is dragged, straight out: no gizmo is in the way.
  await drag(page, end, [860, 480], [870, 490]);
  await done(page, 'Pull');
  const ends = (await handles()).filter(({ from }) => from[0] === 4);
  expect(ends.every(({ from, to }) => to[0]! > 4.1 && to[1] === from[1] && to[2] === from[2])).toBe(true);
  expect(await violations(page)).toEqual([]);

  await page.locator('[data-mode=let-go]').click();
  await page.mouse.click(...front);
  await done(page, 'Let go');
  expect(await groups()).toEqual(['Moved']);
  // Sideways as well, where that is wanted.
  await page.locator('[data-mode=pull]').click();
  await page.locator('[data-act=straight-out]').uncheck();
  await page.keyboard.press('Escape');
  await drag(page, end, [end[0], end[1] - 60]);
  await done(page, 'Pull');
  expect((await handles())[0]!.to[1]! - (await handles())[0]!.from[1]!).toBeGreaterThan(0.2);
});
