import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, inject } from 'vitest';
import { errorsOf, openPage } from './browser.ts';
import { connect } from './connect.ts';

export interface PageFactory {
  readonly browser: Browser;
  readonly url: string;
  /** A page at rest with the first sample carved. It closes after the test, which fails if the page threw anything. */
  open(options?: BrowserContextOptions): Promise<Page>;
}

/** The page as it is shipped, and the browser. */
export function usePage(): PageFactory {
  const { url } = inject('shared');
  let browser: Browser;
  const pages: Page[] = [];
  beforeAll(async () => {
    browser = await connect();
  });
  afterAll(async () => {
    await browser?.close();
  });
  afterEach(async () => {
    for (const page of pages.splice(0)) {
      expect(errorsOf(page)).toEqual([]);
      await page.context().close();
    }
  });
  return {
    get browser() {
      return browser;
    },
    url,
    open: async (options) => {
      const page = await openPage(browser, url, options);
      pages.push(page);
      return page;
    },
  };
}
