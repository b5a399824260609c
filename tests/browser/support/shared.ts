import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { TestProject } from 'vitest/node';
import { makeSamples } from '../../../web/build/samples.mjs';
import { type BrowserName, launchServer } from './launch.ts';
import { buildPage, servePage } from './page-server.ts';
import { buildElement } from './static-server.ts';
import { openScreen } from './virtual-screen.ts';

/** What all files of a run use: built, started and opened once. */
export interface Shared {
  /** Where the page is served. */
  readonly url: string;
  /** Folder of the built element. */
  readonly element: string;
  /** Where the browser is spoken to. */
  readonly wsEndpoint: string;
  /** Where Firefox saves files. */
  readonly downloads: string;
}

declare module 'vitest' {
  interface ProvidedContext {
    /** The browser that this run of the tests drives. */
    browser: BrowserName;
    shared: Shared;
  }
}

/** Builds the page and the element as they are shipped, serves the page and starts the browser, for as long as a project runs. */
export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  const folders = { page: `tests/out/${project.name}/page`, element: `tests/out/${project.name}/element` };
  const make = async (): Promise<void> => {
    await makeSamples();
    await buildPage(folders.page);
    await buildElement(folders.element);
  };
  await make();
  project.onTestsRerun(make);
  const page = await servePage(folders.page);
  const downloads = mkdtempSync(join(tmpdir(), 'whittle-downloads-'));
  const browser = project.getProvidedContext().browser;
  const screen = browser === 'firefox' ? await openScreen() : undefined;
  const server = await launchServer(browser, screen?.display ?? '', downloads);
  project.provide('shared', {
    url: page.url,
    element: folders.element,
    wsEndpoint: server.wsEndpoint(),
    downloads,
  });
  return async () => {
    await server.close();
    screen?.close();
    await page.close();
    rmSync(downloads, { recursive: true });
  };
}
