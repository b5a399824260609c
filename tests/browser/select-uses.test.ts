import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { block } from '../fixtures/hard-edged.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { violations } from './support/axe.ts';
import { carved, drop } from './support/browser.ts';
import { saved } from './support/downloads.ts';
import { done, drag, type Place, takeTool, typeOver } from './support/hands.ts';
import { exported } from './support/headless.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;

/** The right side of a block, which lies across x at 1, and its front, across z, as they are seen at first. */
const right: Place = [770, 500];
const front: Place = [540, 480];

interface SavedStep {
  readonly handles?: { readonly vertices: number[]; readonly targets: number[][] };
  readonly planes?: { readonly vertices: number[]; readonly normal: number[]; readonly offset: number }[];
  readonly frames?: { readonly vertices: number[] }[];
}

async function recipe() {
  const { bytes } = await exported(page, 'Recipe');
  const saved = JSON.parse(bytes.toString()) as {
    steps: SavedStep[];
    groups?: { name: string; vertices: number[] }[];
  };
  return { step: saved.steps[0]!, groups: saved.groups ?? [] };
}

const use = (name: string) => page.getByRole('button', { name, exact: true }).click();

/** A click on a side of the block, which takes all of it. */
async function takeSide(place: Place): Promise<void> {
  await page.mouse.click(...place);
  await page.locator('.selected').filter({ hasText: '169 of 866' }).waitFor();
}

beforeEach(async () => {
  page = await pages.open();
  await drop(page, '#stage', 'block.obj', Buffer.from(objText(block(12))));
  await page.getByRole('button', { name: /Export OBJ/ }).waitFor();
  await carved(page);
  await takeTool(page, 'Select');
  await page.locator('.selected').filter({ hasText: 'Nothing' }).waitFor();
});

it('is held still', async () => {
  await takeSide(right);
  await use('Hold');
  await done(page, 'Hold');
  await page.locator('.selected').filter({ hasText: 'It is held still.' }).waitFor();
  const { step, groups } = await recipe();
  expect(step.handles!.vertices).toHaveLength(169);
  expect(step.handles!.targets.every(([x]) => x === 1)).toBe(true);
  expect(groups.map(({ name }) => name)).toEqual(['Held']);
});

it('with a name is taken hold of by that name, to be moved', async () => {
  await takeSide(front);
  await page.getByLabel('Name for what is selected').fill('face');
  await page.keyboard.press('Enter');
  await use('Move');
  await done(page, 'Take hold');
  await page.getByRole('radio', { name: 'Move' }).waitFor();
  expect(await page.getByRole('radio', { name: 'Move' }).isChecked()).toBe(true);
  await page.locator('.group-name').filter({ hasText: 'face' }).waitFor();
  await typeOver(page.locator('[data-axis=z]'), '0.5');
  await done(page, 'Move');
  const { step, groups } = await recipe();
  expect(groups.map(({ name }) => name)).toContain('face');
  const { vertices } = groups.find(({ name }) => name === 'face')!;
  const targets = vertices.map((vertex) => step.handles!.targets[step.handles!.vertices.indexOf(vertex)]!);
  expect(targets).toHaveLength(169);
  for (const [, , z] of targets) expect(z).toBeCloseTo(1.5, 3);
});

it('is held on a plane, which is dragged by its arrow, typed, laid and removed', async () => {
  await takeSide(right);
  await use('On a plane');
  await done(page, 'Hold on a plane');
  const { step } = await recipe();
  expect(step.planes).toMatchObject([{ normal: [1, 0, 0] }]);
  expect(step.planes![0]!.vertices).toHaveLength(169);
  expect(step.planes![0]!.offset).toBeCloseTo(1, 9);

  const place = page.getByLabel('Where Plane 1 is');
  await drag(page, [790, 437], [810, 440], [830, 443]);
  await done(page, 'Move the plane');
  expect(Number(await place.inputValue())).toBeGreaterThan(1.02);
  await typeOver(place, '1.25');
  await page.waitForFunction(() => {
    const status = document.querySelector<HTMLElement>('whittle-status');
    return status?.dataset.activity === 'idle';
  });
  const [plane] = (await recipe()).step.planes!;
  expect(plane!.offset).toBe(1.25);
  const shaped = await saved(page, () => page.locator('[data-act=export]').click());
  const positions = objPositions(shaped.bytes.toString());
  for (const vertex of plane!.vertices) expect(positions[3 * vertex]).toBeCloseTo(1.25, 8);
  expect(await violations(page)).toEqual([]);

  await page.getByLabel('How Plane 1 lies').selectOption('across y');
  await done(page, 'Turn the plane');
  expect((await recipe()).step.planes![0]!.normal).toEqual([0, 1, 0]);
  await page.getByRole('button', { name: 'Remove Plane 1' }).click();
  await done(page, 'Remove the plane');
  expect((await recipe()).step.planes).toBeUndefined();
});

it('gets a cube of its own, to be turned', async () => {
  await takeSide(right);
  await use('Cube of its own');
  await done(page, 'Cube of its own');
  expect(await page.getByRole('radio', { name: 'Cube', exact: true }).isChecked()).toBe(true);
  expect((await recipe()).step.frames!.map(({ vertices }) => vertices.length)).toEqual([169]);
});
