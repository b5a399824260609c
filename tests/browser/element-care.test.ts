import type { BrowserContextOptions, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { WhittleView } from '../../src/element/index.ts';
import { violations } from './support/axe.ts';
import type { StaticServer } from './support/static-server.ts';
import { docsPage, eventsOf, happened, noteEvents, type Told, useElement } from './support/use-element.ts';

/** What pages do to elements that nobody thought of: attributes that change too soon, elements that move, many of them, no WebGL. */

const docs = (views: string) => docsPage(views, [160, 120]);
const rabbit = '/samples/rabbit.glb';

const element = useElement();

/** What the page notes of itself. */
interface Notes {
  readonly contexts: WebGLRenderingContext[];
}

async function open(
  views: string,
  pages: Readonly<Record<string, string>> = {},
  options: BrowserContextOptions & { readonly noWebGl?: boolean } = {},
): Promise<{ page: Page; workers: () => number; errors: string[]; server: StaticServer }> {
  const server = await element.serve({ '/': docs(views), ...pages });
  const { noWebGl = false, ...context } = options;
  const page = await (await element.browser.newContext({ reducedMotion: 'reduce', ...context })).newPage();
  const errors: string[] = [];
  let workers = 0;
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('worker', () => workers++);
  await noteEvents(page);
  await page.addInitScript((isBlind) => {
    const notes: Notes = { contexts: [] };
    Object.assign(globalThis, notes);
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const isGl = String(args[0]).startsWith('webgl');
      if (isGl && isBlind) return null;
      const context = getContext.apply(this, args as never) as WebGLRenderingContext | null;
      if (isGl && context) notes.contexts.push(context);
      return context;
    } as typeof getContext;
  }, noWebGl);
  await page.goto(`${server.url}/`);
  return { page, workers: () => workers, errors, server };
}

const liveContexts = (page: Page) =>
  page.evaluate(
    () =>
      new Set((globalThis as unknown as Notes).contexts.filter((context) => !context.isContextLost())).size,
  );

it('survives sources that change while it loads and solves, with one worker and no untrue error', async () => {
  const { page, workers, errors } = await open(
    `<whittle-view id="a" src="${rabbit}" method="cubic" alt="A rabbit"></whittle-view>`,
  );
  await happened(page, 'a load');
  await page.evaluate(async () => {
    const element = document.querySelector('#a') as WhittleView;
    for (const [src, lambda] of [
      ['/samples/knot.ply', 0.4],
      ['/samples/vase.obj', 0.5],
      ['/samples/rabbit.glb', 0.6],
    ] as const) {
      Object.assign(element, { src, lambda });
      await new Promise((resolve) => element.addEventListener('load', resolve, { once: true }));
    }
    element.lambda = 0.7;
  });
  await page.waitForFunction(() => /converged/.test((globalThis as unknown as Told).log.at(-1)!));
  const lines = await eventsOf(page);
  expect(lines.filter((line) => line.includes('error'))).toEqual([]);
  expect(lines.filter((line) => line.includes('cancelled'))).toEqual([]);
  expect(workers()).toBe(1);
  expect(errors).toEqual([]);
  await page.context().close();
});

it('goes and comes back, also while it solves and where nobody looks', async () => {
  const { page, errors } = await open(
    `<whittle-view id="a" src="${rabbit}" method="cubic" alt="A rabbit"></whittle-view>
     <div style="height: 4000px"></div>
     <whittle-view id="far" loading="eager" src="${rabbit}" alt="A rabbit"></whittle-view>`,
  );
  await happened(page, 'a load', 'far load');
  expect(await liveContexts(page)).toBe(1);
  await page.evaluate(async () => {
    (globalThis as unknown as Told).log.length = 0;
    for (const id of ['a', 'far']) {
      const element = document.querySelector(`#${id}`)!;
      const parent = element.parentElement!;
      element.remove();
      await new Promise((resolve) => setTimeout(resolve, 0));
      parent.append(element);
    }
    document.querySelector('#a')!.scrollIntoView();
  });
  await happened(page, 'a change', 'far load');
  expect((await eventsOf(page)).filter((line) => line.includes('error'))).toEqual([]);
  expect(errors).toEqual([]);
  await page.evaluate(() => document.querySelector('#a')!.setAttribute('src', ''));
  await page.waitForFunction(() => !document.querySelector('#a')!.shadowRoot!.querySelector('canvas, img'));
  await page.context().close();
});

it('has a context only while it is near the screen, twenty times on a page', async () => {
  const view = (k: number) =>
    `<p style="height: 700px"><whittle-view id="v${k}" loading="eager" src="${rabbit}" alt="Rabbit ${k}"></whittle-view></p>`;
  const { page, errors } = await open(Array.from({ length: 20 }, (_, k) => view(k)).join(''));
  await happened(page, ...Array.from({ length: 20 }, (_, k) => `v${k} load`));
  expect(await liveContexts(page)).toBeLessThanOrEqual(3);
  for (let k = 0; k < 20; k++) {
    await page.evaluate((id) => document.querySelector(id)!.scrollIntoView(), `#v${k}`);
    await page.waitForFunction(
      (id) => document.querySelector(id)!.shadowRoot!.querySelector('canvas'),
      `#v${k}`,
    );
  }
  await expect.poll(() => liveContexts(page)).toBeLessThanOrEqual(3);
  // Where it was left there is a still picture.
  await page.waitForFunction(() => document.querySelector('#v9')!.shadowRoot!.querySelector('.stage img'));
  expect(errors).toEqual([]);
  await page.context().close();
});

it('without WebGL keeps the poster, says so, and gives the file all the same', async () => {
  const { page, errors } = await open(
    `<whittle-view id="a" src="${rabbit}" method="cubic" lambda="0.3" poster="/poster.svg" alt="A rabbit"></whittle-view>`,
    { '/poster.svg': '<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"/>' },
    { noWebGl: true },
  );
  await happened(page, 'a change');
  expect(await page.locator('#a [role=alert]').innerText()).toContain('cannot draw 3D');
  expect(await page.locator('#a [part=poster]').count()).toBe(1);
  expect((await eventsOf(page)).filter((line) => line.startsWith('a error')).length).toBe(1);
  const size = await page.evaluate(
    async () => (await (document.querySelector('#a') as WhittleView).toBlob()).size,
  );
  expect(size).toBeGreaterThan(1000);
  expect(errors).toEqual([]);
  await page.context().close();
});

it('takes a recipe by its address with the files beside it, and goes back to the plain mesh without one', async () => {
  const recipe = { whittle: 1, steps: [{ method: 'polycube', directions: 'directions.json' }] };
  const { page, server } = await open(
    `<whittle-view id="a" src="/samples/vase.obj" recipe="/recipes/mine.json" alt="A vase"></whittle-view>`,
    {
      '/recipes/mine.json': JSON.stringify(recipe),
      '/recipes/directions.json': '[[1,0,0],[-1,0,0],[0,1,0],[0,-1,0],[0,0,1],[0,0,-1]]',
    },
  );
  await happened(page, 'a change');
  expect(server.asked).toContain('/recipes/directions.json');
  const bytes = () =>
    page.evaluate(async () => (await (document.querySelector('#a') as WhittleView).toBlob()).text());
  const plain = await page.evaluate(async () => (await fetch('/samples/vase.obj')).text());
  expect(await bytes()).not.toBe(plain);
  await page.evaluate(() => document.querySelector('#a')!.removeAttribute('recipe'));
  await expect.poll(bytes).toBe(plain);
  await page.context().close();
});

it('names what is wrong by its code, reads odd names, and needs no words to be accessible', async () => {
  const { page, errors } = await open(
    `<whittle-view id="a" src="/100%25%20odd%.obj" alt="None"></whittle-view>
     <whittle-view id="b" src="${rabbit}" method="cubic" lambda="-3" controls></whittle-view>
     <whittle-view id="c" src="${rabbit}" alt=""></whittle-view>`,
  );
  await happened(page, 'a error', 'b load', 'b error', 'c load');
  const lines = await eventsOf(page);
  expect(lines.find((line) => line.startsWith('a error'))).toContain('could not be fetched');
  expect(lines.find((line) => line.startsWith('b error'))).toContain('"code":"bad-parameter"');
  expect(await violations(page)).toEqual([]);
  const name = await page.evaluate(() =>
    document.querySelector('#b')!.shadowRoot!.querySelector('canvas')!.getAttribute('aria-label'),
  );
  expect(name).toBe('rabbit.glb');
  expect(errors).toEqual([]);
  await page.context().close();
});
