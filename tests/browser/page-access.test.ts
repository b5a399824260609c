import { describe, expect, it } from 'vitest';

import { violations } from './support/axe.ts';
import { canEmulate } from './support/connect.ts';
import { usePage } from './support/use-page.ts';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

const pages = usePage();

describe.runIf(canEmulate).each(['light', 'dark'] as const)('in %s', (colorScheme) => {
  it('passes axe closed and with everything open', async () => {
    const page = await pages.open({ colorScheme });
    expect(await violations(page)).toEqual([]);
    for (const summary of await page.locator('details > summary').all()) await summary.click();
    await page.locator('.home .menu-button').click();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.keyboard.press('?');
    expect(await violations(page)).toEqual([]);
  });

  it('passes axe on a phone', async () => {
    const page = await pages.open({ ...phone, colorScheme });
    expect(await violations(page)).toEqual([]);
  });
});

it.runIf(canEmulate)(
  'fits a phone: nothing overflows, the slider is within a thumb’s reach, targets are 44 px',
  async () => {
    const page = await pages.open(phone);
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
  },
);

it('goes through light and dark by its button and remembers', async () => {
  const page = await pages.open({ colorScheme: 'light' });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  expect(await theme()).toBe('light');
  await page.locator('[data-act=theme]').click();
  await page.locator('[data-act=theme]').click();
  expect(await theme()).toBe('dark');
  await page.reload();
  await page.waitForSelector('html[data-theme=dark]');
});

it('without WebGL says so and still carves', async () => {
  const context = await pages.browser.newContext();
  context.setDefaultTimeout(0);
  const page = await context.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(pages.url);
  await page.waitForSelector('.no-canvas[role=alert]');
  expect(await page.locator('.no-canvas').innerText()).toContain('WebGL');
  await page.waitForFunction(() =>
    document.querySelector('whittle-status .sentence')?.textContent?.startsWith('Carved'),
  );
  await context.close();
});
