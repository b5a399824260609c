import { createHash } from 'node:crypto';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { browserName } from './connect.ts';

/**
 * In Chromium, a quarter of the pixels: most of its time went into drawing them with the processor, and pictures are compared, not looked
 * at. Firefox draws them all, and so do pictures of figures that are kept. Where boxes are measured, ask for `deviceScaleFactor: 1`.
 */
const fewerPixels: BrowserContextOptions =
  browserName === 'chromium' && !process.env.WHITTLE_FIGURES ? { deviceScaleFactor: 0.5 } : {};

/** A page at rest with the first sample carved. Whatever it throws fails the test that asks for {@link errorsOf}. */
export async function openPage(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: 1200, height: 800 },
    reducedMotion: 'reduce',
    ...fewerPixels,
    ...options,
  });
  // A wait in vain ends with the test's own time.
  context.setDefaultTimeout(0);
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

/** A worker that a test can lose as a crash would, and how often it has let the page look at a run. */
interface KeptWorker extends Worker {
  looks: number;
}

function keepWorkers(): void {
  const scope = globalThis as unknown as { workers: KeptWorker[]; Worker: typeof Worker };
  scope.workers = [];
  scope.Worker = class extends Worker implements KeptWorker {
    looks = 0;

    constructor(...options: ConstructorParameters<typeof Worker>) {
      super(...options);
      scope.workers.push(this);
      this.addEventListener('message', ({ data }) => {
        if (data.type === 'progress' && data.progress.kind === 'iterating') this.looks++;
      });
    }
  };
}

export function killWorker(page: Page): Promise<void> {
  return page.evaluate(() => {
    const worker = (globalThis as unknown as { workers: KeptWorker[] }).workers.at(-1)!;
    worker.terminate();
    worker.dispatchEvent(new ErrorEvent('error', { message: 'killed by a test' }));
  });
}

/** Waits until as many workers have been started and the last of them is solving. */
export async function solvingInWorker(page: Page, count: number): Promise<void> {
  await page.waitForFunction((count) => {
    const { workers } = globalThis as unknown as { workers: KeptWorker[] };
    return workers.length === count && workers.at(-1)!.looks > 0;
  }, count);
}

export function status(page: Page): Promise<string> {
  return page.locator('whittle-status .sentence').innerText();
}

export async function carved(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const element = document.querySelector<HTMLElement>('whittle-status');
    return (
      element?.dataset.activity === 'idle' &&
      /^(Carved|Shaped|Nothing is held)/.test(element.querySelector('.sentence')?.textContent ?? '')
    );
  });
}

/** Waits for the last entry for undo to be the named one, and for its shape: a control may show a choice before it is acted on. */
export async function entered(page: Page, name: string): Promise<void> {
  await page.waitForSelector(`[data-act=undo][aria-label="Undo ${name}"]`);
  await carved(page);
}

export async function solving(page: Page): Promise<void> {
  await page.waitForFunction(() =>
    /iteration [1-9]/.test(document.querySelector('whittle-status .sentence')?.textContent ?? ''),
  );
}

/** A fingerprint of the part of the canvas that nothing covers, once it is at rest and sharp. */
export async function picture(page: Page): Promise<string> {
  await drawn(page);
  await page.waitForFunction(() => {
    const canvas = document.querySelector('canvas');
    return canvas?.width === Math.floor((canvas?.clientWidth ?? 0) * devicePixelRatio);
  });
  for (let before = ''; ; ) {
    await drawn(page);
    const shot = await page.screenshot({ clip: { x: 20, y: 90, width: 800, height: 620 } });
    const now = createHash('sha256').update(shot).digest('hex');
    if (now === before) return now;
    before = now;
  }
}

/** Waits until what the page has asked to draw is on the screen. */
function drawn(page: Page): Promise<void> {
  return page.evaluate(async () => {
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
  });
}

export function lambda(page: Page): Promise<number> {
  return page.locator('.slider .number').inputValue().then(Number);
}

/**
 * Begins a solve that does not end by itself and is followed live. PolyCube starts each iteration anew from what the last one
 * left: no tolerance ends it, and its shape does not come to rest within any number of iterations that a test could wait for.
 */
export async function solveForever(page: Page): Promise<void> {
  await page.locator('.switch').getByText('Blocks', { exact: true }).click();
  await page.locator('.solver summary').click();
  const iterations = page.getByLabel('Iterations', { exact: true });
  await iterations.fill('1000000');
  await iterations.press('Enter');
  await page.locator('input[type=range]').focus();
  await page.keyboard.down('ArrowRight');
  await solving(page);
}

/** Drops a file on what a selector finds, as a person would who drags it there. */
export async function drop(page: Page, target: string, name: string, bytes: Uint8Array): Promise<void> {
  const dataTransfer = await page.evaluateHandle(
    ([values, file]) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(values)], file));
      return data;
    },
    [[...bytes], name] as const,
  );
  await page.dispatchEvent(target, 'dragenter', { dataTransfer });
  await page.dispatchEvent(target, 'drop', { dataTransfer });
}
