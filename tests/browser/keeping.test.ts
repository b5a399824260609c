import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { runCommandLine } from '../../src/cli/command-line.ts';
import { writePng } from '../../src/inputs/images/png.ts';
import { blankMap, pixelsOfMap } from '../../src/inputs/styles/captures.ts';
import { carved, drop, entered, lambda, openPage, picture } from './support/browser.ts';
import { type SavedFile, saved } from './support/downloads.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();
let page: Page;
let folder: string;

beforeEach(async () => {
  folder = await mkdtemp(join(tmpdir(), 'whittle-keeping-'));
});
afterEach(() => rm(folder, { recursive: true }));

const act = (name: string) => page.locator(`[data-act=${name}]`);
const notice = () => page.locator('.notice').innerText();

/** Chooses an item of the export menu. */
async function choose(label: string): Promise<void> {
  await page.getByRole('button', { name: 'Other ways to export' }).click();
  await page.getByRole('menuitem', { name: new RegExp(`^${label}`) }).click();
}

const exported = (label: string): Promise<SavedFile> => saved(page, () => choose(label));

/** What the page copies. */
async function copied(label: string): Promise<string> {
  await page.evaluate(() => {
    Object.defineProperty(navigator, 'clipboard', {
      value: { writeText: async (text: string) => Object.assign(globalThis, { copied: text }) },
    });
  });
  await choose(label);
  await page.waitForFunction(() => 'copied' in globalThis);
  return page.evaluate(() => (globalThis as unknown as { copied: string }).copied);
}

async function headless(words: readonly string[], stdin = ''): Promise<void> {
  let said = '';
  const code = await runCommandLine(words, {
    stdin: Readable.from([Buffer.from(stdin)]),
    stdout: { write: () => true },
    stderr: { write: (text) => (said += text) },
    signal: new AbortController().signal,
  });
  expect([code, said]).toEqual([0, '']);
}

/** Sets the strength from the keyboard, as one entry. */
async function strengthen(): Promise<void> {
  await page.locator('input[type=range]').first().focus();
  await page.keyboard.press('End');
  await carved(page);
}

/** Waits until nothing would be lost. */
async function kept(): Promise<void> {
  await page.waitForFunction(() => dispatchEvent(new Event('beforeunload', { cancelable: true })));
}

async function paint(): Promise<void> {
  await page.locator('.switch label').nth(1).click();
  await entered(page, 'Octahedron');
  await act('paint').click();
  const box = (await page.locator('.ball').boundingBox())!;
  await page.mouse.move(box.x + 60, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 90, box.y + 80, { steps: 4 });
  await page.mouse.up();
  await entered(page, 'Stroke');
}

describe('a project file', () => {
  it('holds a painted ball and what is switched off, opens again, and gives the same bytes everywhere', async () => {
    page = await pages.open();
    await page.getByRole('button', { name: 'Add a step' }).click();
    await page.getByRole('menuitem', { name: /^Paper/ }).click();
    await page.waitForSelector('.stack [data-step="2"]');
    await carved(page);
    await page.getByLabel('Paper is on').uncheck();
    await carved(page);
    await page.locator('[data-step="1"] .step-name').click();
    await paint();
    const project = await exported('Project');
    const shaped = await exported('glTF binary');
    expect(project.name).toBe('rabbit.whittle.zip');

    const path = join(folder, project.name);
    await writeFile(path, project.bytes);
    await headless(['run', path, '--out', join(folder, 'headless.glb')]);
    expect((await readFile(join(folder, 'headless.glb'))).equals(shaped.bytes)).toBe(true);

    page = await pages.open();
    await drop(page, '#canvas', project.name, project.bytes);
    await page.waitForSelector('.stack [data-step="2"][data-off]');
    await carved(page);
    expect((await exported('glTF binary')).bytes.equals(shaped.bytes)).toBe(true);
    expect((await exported('Project')).bytes.equals(project.bytes)).toBe(true);
  });

  it('is refused in a sentence where it is broken, and the mesh stays', async () => {
    page = await pages.open();
    const { name, bytes } = await exported('Project');
    const before = await picture(page);
    await drop(page, '#canvas', name, bytes.subarray(0, bytes.length / 2));
    await page.locator('[role=alert] .notice').waitFor();
    await page.keyboard.press('Escape');
    expect(await picture(page)).toBe(before);
  });
});

describe('a recipe file', () => {
  const recipe = (steps: object[]) => Buffer.from(JSON.stringify({ whittle: 1, steps }));

  it('goes on the mesh that is there, as one entry that says so', async () => {
    page = await pages.open();
    const before = await picture(page);
    const steps = [{ method: 'polycube' }, { method: 'cubic', lambda: 0.5 }];
    await drop(page, '#canvas', 'blocks.whittle.json', recipe(steps));
    await entered(page, 'Recipe blocks.whittle.json');
    expect(await notice()).toBe('Took the recipe blocks.whittle.json. Its 2 steps are now on rabbit.glb.');
    expect(await page.locator('.stack .step-name').allInnerTexts()).toEqual(['1Blocks: cube', '2Cubic']);
    await act('undo').click();
    expect(await picture(page)).toBe(before);
  });

  it('asks for the files that it names', async () => {
    page = await pages.open();
    const bytes = recipe([{ method: 'analogy', style: 'own.png' }]);
    await drop(page, '#canvas', 'own.whittle.json', bytes);
    await page.waitForSelector('.notice');
    expect(await notice()).toContain('own.whittle.json names own.png');
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), act('again').click()]);
    const buffer = Buffer.from(writePng(pixelsOfMap(blankMap(), 64)));
    await chooser.setFiles([{ name: 'own.png', mimeType: 'image/png', buffer }]);
    await entered(page, 'Recipe own.whittle.json');
    expect(await page.locator('.tile[aria-selected=true]').getAttribute('title')).toBe('own');
  });

  it('is refused with its place where it is wrong', async () => {
    page = await pages.open();
    await drop(page, '#canvas', 'a.json', recipe([{ method: 'cubik' }]));
    const alert = page.locator('[role=alert] .notice');
    await alert.waitFor();
    expect(await alert.innerText()).toContain('a.json, step 1: there is no method “cubik”. Did you mean');
  });
});

describe('work', () => {
  it('is there again after a reload and in the next window, until one starts fresh', async () => {
    page = await pages.open();
    const untouched = await lambda(page);
    await strengthen();
    const [strong, shape] = [await lambda(page), await picture(page)];
    await kept();
    await page.reload();
    await carved(page);
    expect(await notice()).toContain('rabbit.glb is as you left it');
    await act('dismiss').click();
    expect([await lambda(page), await picture(page)]).toEqual([strong, shape]);

    const second = await page.context().newPage();
    await page.close();
    page = second;
    await page.goto(pages.url);
    await carved(page);
    expect(await lambda(page)).toBe(strong);
    await act('again').click();
    await page.waitForFunction(
      (value) => document.querySelector<HTMLInputElement>('.slider .number')?.valueAsNumber === value,
      untouched,
    );
    await carved(page);
    await page.reload();
    await carved(page);
    expect(await lambda(page)).toBe(untouched);
    expect(await page.locator('.notice').count()).toBe(0);
  });

  it('of two windows is kept apart', async () => {
    page = await pages.open();
    await strengthen();
    const strong = await lambda(page);
    await kept();
    const first = page;
    page = await first.context().newPage();
    await page.goto(pages.url);
    await carved(page);
    const plain = await lambda(page);
    expect(plain).toBeLessThan(strong);
    await page.locator('input[type=range]').focus();
    await page.keyboard.press('Home');
    await carved(page);
    await kept();
    for (const [window, value] of [
      [first, strong],
      [page, 0],
    ] as const) {
      await window.reload();
      await carved(window);
      expect(await lambda(window)).toBe(value);
    }
    await first.close();
    await act('again').click();
    await page.waitForFunction(
      (value) => document.querySelector<HTMLInputElement>('.slider .number')?.valueAsNumber === value,
      plain,
    );
    await carved(page);
    await page.reload();
    await carved(page);
    expect(await lambda(page)).toBe(plain);
  });

  it('is asked for before leaving only while it is not kept', async () => {
    page = await pages.open();
    const asks: string[] = [];
    page.on('dialog', (dialog) => {
      asks.push(dialog.type());
      void dialog.dismiss();
    });
    await page.evaluate(() => {
      // What keeps waits for as long as this test wants.
      const real = IDBObjectStore.prototype.put;
      IDBObjectStore.prototype.put = function (value, key) {
        if ((globalThis as unknown as { isFull: boolean }).isFull)
          throw new DOMException('full', 'QuotaExceededError');
        return real.call(this, value, key);
      };
      Object.assign(globalThis, { isFull: true });
    });
    await strengthen();
    await page.waitForSelector('.notice');
    expect(await notice()).toContain('keeps nothing');
    await page.close({ runBeforeUnload: true });
    await expect.poll(() => asks).toEqual(['beforeunload']);
    await page.evaluate(() => Object.assign(globalThis, { isFull: false }));
    await page.locator('input[type=range]').focus();
    await page.keyboard.press('Home');
    await page.waitForFunction(
      () => document.querySelector<HTMLInputElement>('.slider .number')?.valueAsNumber === 0,
    );
    await kept();
    const closed = page.waitForEvent('close');
    await page.close({ runBeforeUnload: true });
    await closed;
    expect(asks).toEqual(['beforeunload']);
  });
});

describe('a link', () => {
  it('that was worked on is as it was left after a reload, and leaves other work alone', async () => {
    page = await pages.open();
    await strengthen();
    const strong = await lambda(page);
    await kept();
    const recipe = encodeURIComponent('{"whittle":1,"steps":[{"method":"cubic","lambda":0.7}]}');
    const link = `${pages.url}?src=samples/vase.obj#recipe=${recipe}`;
    await page.goto(link);
    await carved(page);
    expect(await lambda(page)).toBe(0.7);
    await page.locator('input[type=range]').focus();
    await page.keyboard.press('Home');
    await page.waitForSelector('[data-act=undo]:not([disabled])');
    await kept();
    await page.reload();
    await carved(page);
    expect(await lambda(page)).toBe(0);
    const next = await page.context().newPage();
    await next.goto(pages.url);
    await carved(next);
    expect(await lambda(next)).toBe(strong);
  });

  it('leads to the same shape', async () => {
    page = await pages.open();
    await page.getByRole('button', { name: 'Add a step' }).click();
    await page.getByRole('menuitem', { name: /^Paper/ }).click();
    await page.waitForSelector('.stack [data-step="2"]');
    await carved(page);
    const link = await copied('Copy a link');
    expect(link).toContain('?src=samples/rabbit.glb#recipe=');
    const { bytes } = await exported('glTF binary');
    page = await openPage(pages.browser, link);
    await page.waitForSelector('.stack [data-step="2"]');
    await carved(page);
    expect((await exported('glTF binary')).bytes.equals(bytes)).toBe(true);
    await page.context().close();
  });

  it('cannot hold a file of one’s own, and offers the project', async () => {
    page = await pages.open();
    await drop(
      page,
      '#canvas',
      'tetra.obj',
      Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n'),
    );
    await page.waitForFunction(() => document.querySelector('.report small')?.textContent === '4 faces');
    await carved(page);
    await choose('Copy a link');
    await page.waitForSelector('.notice');
    expect(await notice()).toContain('tetra.obj, which is on your computer only');
    expect((await saved(page, () => act('again').click())).name).toBe('tetra.whittle.zip');
  });

  it('that leads nowhere is said, and the page opens all the same', async () => {
    page = await openPage(pages.browser, `${pages.url}?src=http://127.0.0.1:1/gone.obj`);
    const alert = page.locator('[role=alert] .notice');
    await alert.waitFor();
    expect(await alert.innerText()).toContain('gone.obj could not be fetched: 127.0.0.1:1');
    await page.context().close();
  });
});

it('is copied as a command that a shell runs to the same bytes', async () => {
  page = await pages.open();
  await drop(
    page,
    '#canvas',
    'two.whittle.json',
    Buffer.from(
      '{"whittle":1,"steps":[{"method":"cubic","lambda":0.3},{"method":"cubic","lambdaAxes":[1,0,1]}]}',
    ),
  );
  await entered(page, 'Recipe two.whittle.json');
  const { bytes } = await exported('glTF binary');
  const text = await copied('Copy as a command');
  const shell = `npx() { printf '%s\\n' "$@" > words; cat > stdin; }\n${text}`;
  execFileSync('bash', ['-c', shell], { cwd: folder });
  const words = (await readFile(join(folder, 'words'), 'utf8')).trim().split('\n');
  expect(words).toEqual(['whittle', 'run', '-', 'rabbit.glb', '--out', 'rabbit-whittled.glb']);
  const out = join(folder, 'out.glb');
  await headless(
    ['run', '-', 'public/samples/rabbit.glb', '--out', out],
    await readFile(join(folder, 'stdin'), 'utf8'),
  );
  expect((await readFile(out)).equals(bytes)).toBe(true);
});
