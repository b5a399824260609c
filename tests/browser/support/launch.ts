import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Browser, chromium, firefox } from 'playwright-core';
import { inject } from 'vitest';
import { findBrowser } from '../../../wasm/tools/browsers.mjs';

export type BrowserName = 'chromium' | 'firefox';

declare module 'vitest' {
  interface ProvidedContext {
    /** The browser that this run of the tests drives. */
    browser: BrowserName;
  }
}

export const browserName: BrowserName = inject('browser');

/** Where Firefox saves files. */
export const downloadsFolder = mkdtempSync(join(tmpdir(), 'whittle-downloads-'));

/** Whether a page can be told that it is on a phone or in the dark; over WebDriver BiDi it cannot yet. */
export const canEmulate = browserName === 'chromium';

/** Starts the system's own browser. */
export function launch(): Promise<Browser> {
  const executablePath = findBrowser(browserName);
  if (!executablePath) throw new Error(`There is no ${browserName} here; install it and run this again.`);
  return browserName === 'chromium' ? launchChromium(executablePath) : launchFirefox(executablePath);
}

function launchChromium(executablePath: string): Promise<Browser> {
  const args = [
    '--no-sandbox',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
  ];
  return chromium.launch({ executablePath, args });
}

/**
 * Stock Firefox, by WebDriver BiDi, on the virtual screen of the run and drawn by the processor. Playwright 1.65 begins every page
 * with a command that Firefox ESR 153 does not know (`emulation.setMediaFeaturesOverride`); 1.64 does not.
 */
function launchFirefox(executablePath: string): Promise<Browser> {
  const display = inject('display');
  return firefox.launch({
    channel: 'moz-firefox',
    executablePath,
    headless: false,
    downloadsPath: downloadsFolder,
    env: { ...process.env, ...(display ? { DISPLAY: display } : {}), LIBGL_ALWAYS_SOFTWARE: '1' },
    firefoxUserPrefs: { 'ui.prefersReducedMotion': 1, 'webgl.force-enabled': true },
  });
}
