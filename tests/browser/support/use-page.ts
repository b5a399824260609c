import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { errorsOf, openPage } from './browser.ts';
import { launch } from './launch.ts';
import { type PageServer, servePage } from './page-server.ts';

export interface PageFactory {
  readonly browser: Browser;
  readonly url: string;
  /** A page at rest with the first sample carved. It closes after the test, which fails if the page threw anything. */
  open(options?: BrowserContextOptions): Promise<Page>;
}

/** One server and one browser for all tests of a file. */
export function usePage(): PageFactory {
  let server: PageServer;
  let browser: Browser;
  const pages: Page[] = [];
  beforeAll(async () => {
    server = await servePage();
    browser = await launch();
  });
  afterAll(async () => {
    await browser?.close();
    await server?.close();
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
    get url() {
      return server.url;
    },
    open: async (options) => {
      const page = await openPage(browser, server.url, options);
      pages.push(page);
      return page;
    },
  };
}
