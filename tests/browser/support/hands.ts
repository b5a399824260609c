import type { Locator, Page } from 'playwright-core';
import { picture } from './browser.ts';

export type Place = readonly [x: number, y: number];

/** Takes a tool from the strip and waits until it can take something of the mesh, and the view is at rest. */
export async function takeTool(page: Page, title: string): Promise<void> {
  await page.locator('.strip').getByText(title, { exact: true }).click();
  await page.waitForSelector('.strip[aria-busy=false]');
  // The view makes room for its options.
  await picture(page);
}

/** Presses, goes through places of the window and lets go. */
export async function drag(page: Page, ...[first, ...others]: readonly Place[]): Promise<void> {
  await page.mouse.move(...first!);
  await page.mouse.down();
  for (const place of others) await page.mouse.move(...place, { steps: 4 });
  await page.mouse.up();
}

/** Waits for the last entry for undo to be the named one, and for its shape. */
export async function done(page: Page, entry: string): Promise<void> {
  await page.waitForSelector(`[data-act=undo][aria-label="Undo ${entry}"]`);
  await page.waitForSelector('whittle-status[data-activity=idle]');
}

/** Fingers on the window: each call says where all of them are now. Chromium only. */
export async function fingers(page: Page) {
  const session = await page.context().newCDPSession(page);
  return async (
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    ...places: readonly Place[]
  ): Promise<void> => {
    const touchPoints = places.map(([x, y], id) => ({ x, y, id }));
    await session.send('Input.dispatchTouchEvent', { type, touchPoints });
  };
}

/** Types a value in place of a field's own, key by key, and ends with Enter. (Firefox does not take `fill` for an edit of a number.) */
export async function typeOver(field: Locator, value: string): Promise<void> {
  await field.focus();
  await field.press('Control+A');
  await field.pressSequentially(value);
  await field.press('Enter');
}
