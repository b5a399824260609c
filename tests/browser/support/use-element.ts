import type { Browser } from 'playwright-core';
import { afterAll, beforeAll } from 'vitest';
import { makeSamples } from '../../../web/build/samples.mjs';
import { launch } from './launch.ts';
import { buildElement, type StaticServer, serveStatic } from './static-server.ts';

/** Where the samples lie, from the root of the tree. */
export const samples = 'public/samples';

export interface ElementPages {
  readonly browser: Browser;
  /** Serves the built element at /whittle and the samples at /samples, until the tests of the file are over. */
  serve(pages: Readonly<Record<string, string>>, csp?: string): Promise<StaticServer>;
}

/** The element as it is shipped, and one browser, for all tests of a file. */
export function useElement(): ElementPages {
  let browser: Browser;
  let folders: Record<string, string>;
  const servers: StaticServer[] = [];
  beforeAll(async () => {
    await makeSamples();
    folders = { whittle: await buildElement(), samples };
    browser = await launch();
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
