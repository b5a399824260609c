import { createRequire } from 'node:module';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, openPage } from './support/browser.ts';
import { type PageServer, servePage } from './support/page-server.ts';

const axe = createRequire(import.meta.url).resolve('axe-core');
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

let server: PageServer;
let browser: Browser;

beforeAll(async () => {
  server = await servePage();
  browser = await launch();
});
afterAll(async () => {
  await browser?.close();
  await server?.close();
});

async function violations(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axe });
  return page.evaluate(async () => {
    const { axe } = globalThis as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    const found = (await axe.run()).violations;
    return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' | ')}`);
  });
}

describe.each(['light', 'dark'] as const)('in %s', (colorScheme) => {
  it('passes axe closed and with everything open', async () => {
    const page = await openPage(browser, server.url, { colorScheme });
    expect(await violations(page)).toEqual([]);
    for (const summary of await page.locator('details > summary').all()) await summary.click();
    await page.locator('.home .menu-button').click();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.keyboard.press('?');
    expect(await violations(page)).toEqual([]);
    await page.context().close();
  });

  it('passes axe on a phone', async () => {
    const page = await openPage(browser, server.url, { ...phone, colorScheme });
    expect(await violations(page)).toEqual([]);
    await page.context().close();
  });
});

it('fits a phone: nothing overflows, the slider is within a thumb’s reach, targets are 44 px', async () => {
  const page = await openPage(browser, server.url, phone);
  const found = await page.evaluate(() => {
    const seen = (element: Element) => element.getBoundingClientRect().width > 1;
    const targets = [
      ...document.querySelectorAll('button, summary, input[type=range], .segments label'),
    ].filter(seen);
    const size = (element: Element) => {
      const { width, height } = element.getBoundingClientRect();
      return Math.min(width, height);
    };
    return {
      overflow: document.documentElement.scrollWidth - innerWidth,
      small: targets
        .filter((element) => size(element) < 43.5)
        .map((element) => element.outerHTML.slice(0, 120)),
      slider: document.querySelector('input[type=range]')!.getBoundingClientRect().top / innerHeight,
    };
  });
  expect(found.overflow).toBeLessThanOrEqual(0);
  expect(found.small).toEqual([]);
  expect(found.slider).toBeGreaterThan(0.55);
  await page.context().close();
});

it('goes through light and dark by its button and remembers', async () => {
  const page = await openPage(browser, server.url, { colorScheme: 'light' });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  expect(await theme()).toBe('light');
  await page.locator('[data-act=theme]').click();
  await page.locator('[data-act=theme]').click();
  expect(await theme()).toBe('dark');
  await page.reload();
  await page.waitForSelector('html[data-theme=dark]');
  await page.context().close();
});

it('without WebGL says so and still carves', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(server.url);
  await page.waitForSelector('[role=alert] .notice');
  expect(await page.locator('.notice').innerText()).toContain('WebGL');
  await page.waitForFunction(() =>
    document.querySelector('whittle-status .sentence')?.textContent?.startsWith('Carved'),
  );
  await context.close();
});
