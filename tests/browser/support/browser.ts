import { createHash } from 'node:crypto';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';

const flags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export function launch(): Promise<Browser> {
  return chromium.launch({ executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium', args: flags });
}

/** A page at rest with the first sample carved. Whatever it throws fails the test that asks for {@link errorsOf}. */
export async function openPage(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: 1200, height: 800 },
    reducedMotion: 'reduce',
    ...options,
  });
  const page = await context.newPage();
  const errors: string[] = [];
  thrown.set(page, errors);
  page.on('pageerror', (error) => errors.push(error.message));
  await page.addInitScript(keepWorkers);
  await page.goto(url);
  await carved(page);
  return page;
}

const thrown = new WeakMap<Page, string[]>();

export function errorsOf(page: Page): readonly string[] {
  return thrown.get(page) ?? [];
}

/** So that a test can lose the worker as a crash would. */
function keepWorkers(): void {
  const scope = globalThis as unknown as { workers: Worker[]; Worker: typeof Worker };
  scope.workers = [];
  scope.Worker = class extends Worker {
    constructor(...options: ConstructorParameters<typeof Worker>) {
      super(...options);
      scope.workers.push(this);
    }
  };
}

export function killWorker(page: Page): Promise<void> {
  return page.evaluate(() => {
    const worker = (globalThis as unknown as { workers: Worker[] }).workers.at(-1)!;
    worker.terminate();
    worker.dispatchEvent(new ErrorEvent('error', { message: 'killed by a test' }));
  });
}

export function workersStarted(page: Page): Promise<number> {
  return page.evaluate(() => (globalThis as unknown as { workers: Worker[] }).workers.length);
}

export function status(page: Page): Promise<string> {
  return page.locator('whittle-status .sentence').innerText();
}

export async function carved(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const element = document.querySelector<HTMLElement>('whittle-status');
    return (
      element?.dataset.activity === 'idle' &&
      /^Carved/.test(element.querySelector('.sentence')?.textContent ?? '')
    );
  });
}

export async function solving(page: Page): Promise<void> {
  await page.waitForFunction(() =>
    /iteration [1-9]/.test(document.querySelector('whittle-status .sentence')?.textContent ?? ''),
  );
}

/** A fingerprint of the part of the canvas that nothing covers, once it is at rest and sharp. */
export async function picture(page: Page): Promise<string> {
  await page.waitForTimeout(400);
  await page.waitForFunction(() => {
    const canvas = document.querySelector('canvas');
    return canvas?.width === Math.floor((canvas?.clientWidth ?? 0) * devicePixelRatio);
  });
  const shot = await page.screenshot({ clip: { x: 20, y: 90, width: 800, height: 620 } });
  return createHash('sha256').update(shot).digest('hex');
}

export function lambda(page: Page): Promise<number> {
  return page.locator('.slider .number').inputValue().then(Number);
}

/** A solve that does not end by itself, followed live from a key press on the slider. */
export async function solveForever(page: Page): Promise<void> {
  await page.locator('.more summary').click();
  await setField(page, 'Iterations at most', '1000000');
  await carved(page);
  await setField(page, 'Tolerance', '0');
}

async function setField(page: Page, label: string, value: string): Promise<void> {
  const field = page.getByLabel(label);
  await field.fill(value);
  await field.press('Enter');
}
