import { type Browser, chromium, firefox } from 'playwright-core';
import { inject } from 'vitest';
import type { BrowserName } from './launch.ts';

export const browserName: BrowserName = inject('browser');

/** Whether a page can be told that it is on a phone or in the dark; over WebDriver BiDi it cannot yet. */
export const canEmulate = browserName === 'chromium';

/** The browser of the run; what a file opens in it is closed with its connection. */
export function connect(): Promise<Browser> {
  const { wsEndpoint } = inject('shared');
  return (browserName === 'chromium' ? chromium : firefox).connect(wsEndpoint);
}
