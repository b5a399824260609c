import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { runCommandLine } from '../../src/cli/command-line.ts';
import type { WhittleView } from '../../src/element/index.ts';
import { violations } from './support/axe.ts';
import { docsPage, happened, noteEvents, samples, type Told, useElement } from './support/use-element.ts';

const strict = "script-src 'self' 'wasm-unsafe-eval'";

const docs = (views: string, scripts?: string) => docsPage(views, [320, 240], scripts);

const four = `
  <whittle-view id="plain" src="/samples/vase.obj" alt="A vase"></whittle-view>
  <whittle-view id="cubic" src="/samples/rabbit.glb" method="cubic" lambda="0.3" alt="A rabbit carved into a cube" controls></whittle-view>
  <whittle-view id="style" src="/samples/rabbit.glb" method="analogy" style-src="octahedron" alt="A rabbit of eight sides"></whittle-view>
  <whittle-view id="recipe" src="/samples/knot.ply" recipe='{"whittle":1,"steps":[{"method":"cubic","lambda":0.1},{"method":"developable","maxIterations":5}]}' alt="A folded knot"></whittle-view>`;

const element = useElement();

async function open(url: string): Promise<{ page: Page; errors: string[] }> {
  const page = await (await element.browser.newContext({ reducedMotion: 'reduce' })).newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await noteEvents(page);
  await page.goto(url);
  return { page, errors };
}

it('works four times on a static page under a strict policy, with one worker, and gives the command line’s bytes', async () => {
  const server = await element.serve({ '/': docs(four) }, strict);
  const { page, errors } = await open(`${server.url}/`);
  await page.evaluate(() => document.querySelector('#recipe')!.scrollIntoView());
  await happened(page, 'plain load', 'cubic load', 'cubic change', 'style change', 'recipe change');
  expect(errors).toEqual([]);
  expect(page.workers()).toHaveLength(1);
  expect(server.asked.filter((path) => path.endsWith('.wasm'))).toHaveLength(1);
  const bytes = await page.evaluate(async () => {
    const blob = await (document.querySelector('#cubic') as WhittleView).toBlob();
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
  const out = 'tests/out/element-cubic.glb';
  const quiet = { write: () => true };
  const words = ['cubic', `${samples}/rabbit.glb`, '--lambda', '0.3', '--out', out];
  await runCommandLine(words, { stdout: quiet, stderr: quiet, signal: new AbortController().signal });
  expect(Buffer.from(bytes).equals(await readFile(out))).toBe(true);
  expect(await violations(page)).toEqual([]);
  await page.context().close();
});

it('shows a plain mesh without fetching the core', async () => {
  const server = await element.serve(
    { '/': docs('<whittle-view id="plain" src="/samples/vase.obj" alt="A vase"></whittle-view>') },
    strict,
  );
  const { page } = await open(`${server.url}/`);
  await happened(page, 'plain load');
  expect(server.asked.some((path) => path.endsWith('.wasm'))).toBe(false);
  const url = await page.evaluate(() => (document.querySelector('#plain') as WhittleView).toDataURL());
  expect(url).toMatch(/^data:image\/png;base64,/);
  await page.context().close();
});

it('follows its attributes and its slider, and can be cancelled and reset', async () => {
  const view =
    '<whittle-view id="a" src="/samples/rabbit.glb" method="cubic" lambda="0.2" controls alt="A rabbit"></whittle-view>';
  const server = await element.serve({ '/': docs(view) }, strict);
  const { page } = await open(`${server.url}/`);
  await happened(page, 'a change');
  const shape = () =>
    page.evaluate(async () => {
      const blob = await (document.querySelector('#a') as WhittleView).toBlob('obj');
      return (await blob.text()).length + (await blob.text()).slice(0, 2000);
    });
  const before = await shape();
  await page.evaluate(() => document.querySelector('#a')!.setAttribute('lambda', '0.6'));
  await page.waitForFunction(
    () => (globalThis as unknown as Told).log.filter((event) => event.startsWith('a change:')).length > 1,
  );
  const after = await shape();
  expect(after).not.toBe(before);
  await page.locator('#a input').fill('1.5');
  await page.locator('#a input').dispatchEvent('change');
  const moved = await shape();
  expect(moved).not.toBe(after);
  await page.getByRole('button', { name: 'Reset' }).click();
  await page.waitForFunction(
    () => (document.querySelector('#a') as WhittleView).shadowRoot!.querySelector('.progress') === null,
  );
  expect(await shape()).toBe(after);
  await page.evaluate(() => {
    const element = document.querySelector('#a') as WhittleView;
    element.method = 'polycube';
    element.cancel();
  });
  await page.context().close();
});

it('works with its files on another origin, whose worker a page may not start', async () => {
  const cdn = await element.serve({});
  const view = '<whittle-view id="a" src="/samples/rabbit.glb" method="cubic" alt="A rabbit"></whittle-view>';
  const server = await element.serve({ '/': docs(view, `${cdn.url}/whittle`) });
  const { page, errors } = await open(`${server.url}/`);
  await happened(page, 'a change');
  expect(server.asked.filter((path) => path.startsWith('/whittle'))).toEqual([]);
  expect(errors).toEqual([]);
  await page.context().close();
});

it('says what is wrong, and frees what it has when it leaves the page', async () => {
  const view = '<whittle-view id="a" src="/samples/none.glb" method="cubic" alt="Nothing"></whittle-view>';
  const server = await element.serve({ '/': docs(view) }, strict);
  const { page } = await open(`${server.url}/`);
  await happened(page, 'a error');
  expect(await page.locator('#a [role=alert] p').innerText()).toContain(
    'none.glb could not be fetched: the server answered 404',
  );
  await page.evaluate(() => {
    const element = document.querySelector('#a') as WhittleView;
    element.src = '/samples/rabbit.glb';
    element.method = 'cubik';
  });
  await happened(page, 'a load');
  await page.waitForFunction(() =>
    /Did you mean “cubic”/.test(document.querySelector('#a')!.shadowRoot!.textContent!),
  );
  await page.evaluate(() => document.querySelector('#a')!.remove());
  await expect.poll(() => page.workers().length).toBe(0);
  await page.context().close();
});
