import { type BrowserServer, chromium, firefox } from 'playwright-core';
import { findBrowser } from '../../../wasm/tools/browsers.mjs';

export type BrowserName = 'chromium' | 'firefox';

/**
 * Starts the system's own browser, for all files of a run.
 *
 * @param display number of the screen on which Firefox is to be, ':1'; empty for the system's own
 * @param downloads folder in which Firefox saves files
 */
export function launchServer(name: BrowserName, display: string, downloads: string): Promise<BrowserServer> {
  const executablePath = findBrowser(name);
  if (!executablePath) throw new Error(`There is no ${name} here; install it and run this again.`);
  return name === 'chromium'
    ? launchChromium(executablePath)
    : launchFirefox(executablePath, display, downloads);
}

/**
 * What Chromium is to do without. Of several lists it takes the last, so what Playwright 1.64 turns off for steadiness stands here again.
 */
const withoutFeatures = [
  'AvoidCorsURLLoaderRestartOnRedirect',
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'BlockOriginHeaderModificationOnRedirect',
  'DestroyProfileOnBrowserClose',
  'HttpsUpgrades',
  'LensOverlay',
  'MediaRouter',
  'NetworkTimeServiceQuerying',
  'OptimizationHints',
  'PaintHolding',
  'ThirdPartyStoragePartitioning',
  'Translate',
  // Two pages for what falls out of the address bar, in a process of their own, made anew for each window that a test opens.
  'WebUIOmniboxAimPopup',
  'WebUIOmniboxPopup',
];

function launchChromium(executablePath: string): Promise<BrowserServer> {
  const args = [
    '--no-sandbox',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    `--disable-features=${withoutFeatures}`,
    // Smooth edges take the processor as long as all the rest of a picture; Firefox draws them.
    ...(process.env.WHITTLE_FIGURES ? [] : ['--webgl-antialiasing-mode=none']),
  ];
  return chromium.launchServer({ host: '127.0.0.1', executablePath, args });
}

/**
 * Stock Firefox, by WebDriver BiDi, drawn by the processor. Playwright 1.65 begins every page with a command that Firefox ESR 153 does
 * not know (`emulation.setMediaFeaturesOverride`); 1.64 does not.
 */
function launchFirefox(
  executablePath: string,
  display: string,
  downloadsPath: string,
): Promise<BrowserServer> {
  return firefox.launchServer({
    host: '127.0.0.1',
    channel: 'moz-firefox',
    executablePath,
    headless: false,
    downloadsPath,
    env: { ...process.env, ...(display ? { DISPLAY: display } : {}), LIBGL_ALWAYS_SOFTWARE: '1' },
    firefoxUserPrefs: { 'ui.prefersReducedMotion': 1, 'webgl.force-enabled': true },
  });
}
