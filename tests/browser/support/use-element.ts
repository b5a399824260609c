import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, inject } from 'vitest';
import { connect } from './connect.ts';
import { type StaticServer, serveStatic } from './static-server.ts';

/** Where the samples lie, from the root of the tree. */
export const samples = 'public/samples';

export interface ElementPages {
  readonly browser: Browser;
  /** Serves the built element at /whittle and the samples at /samples, until the tests of the file are over. */
  serve(pages: Readonly<Record<string, string>>, csp?: string): Promise<StaticServer>;
}

/** The element as it is shipped, and the browser. */
export function useElement(): ElementPages {
  let browser: Browser;
  const folders = { whittle: inject('shared').element, samples };
  const servers: StaticServer[] = [];
  beforeAll(async () => {
    browser = await connect();
  });
  afterAll(async () => {
    await browser?.close();
    for (const server of servers) await server.close();
  });
  return {
    get browser() {
      return browser;
    },
    serve: async (pages, csp) => {
      const server = await serveStatic(folders, pages, csp);
      servers.push(server);
      return server;
    },
  };
}

/** A page of docs around elements. @param scripts where the element's files lie */
export function docsPage(
  views: string,
  [width, height]: readonly [number, number],
  scripts = '/whittle',
): string {
  return `<!doctype html>
<html lang="en"><head><title>Docs</title><style>whittle-view { width: ${width}px; height: ${height}px; }</style>
<script type="module" src="${scripts}/whittle-view.js"></script></head>
<body><main><h1>How to whittle</h1>${views}</main></body></html>`;
}

/** What the elements of a page have told. */
export interface Told {
  /** “id event: detail” */
  readonly log: string[];
}

/** Notes the events of all elements from the first on: some are there before anybody can listen to them. */
export async function noteEvents(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const told: Told = { log: [] };
    Object.assign(globalThis, told);
    for (const name of ['load', 'change', 'error'])
      document.addEventListener(
        name,
        (event) => {
          const { target } = event;
          if (target instanceof Element && target.localName === 'whittle-view')
            told.log.push(`${target.id} ${name}: ${JSON.stringify((event as CustomEvent).detail)}`);
        },
        true,
      );
  });
}

export const eventsOf = (page: Page): Promise<string[]> =>
  page.evaluate(() => (globalThis as unknown as Told).log);

/** Waits until events have happened, each told as “id event”. */
export async function happened(page: Page, ...events: string[]): Promise<void> {
  await page.waitForFunction(
    (wanted) =>
      wanted.every((event) =>
        (globalThis as unknown as Told).log.some((line) => line.startsWith(`${event}:`)),
      ),
    events,
  );
}
