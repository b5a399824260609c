import type { Page } from 'playwright-core';
import { carved, drop } from '../browser/support/browser.ts';
import { done, drag, type Place, takeTool } from '../browser/support/hands.ts';

/** What a person does on the page: presses, moves and lets go. Nothing here calls into the page’s code. */
export class Hand {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  async openSample(title: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Samples' }).click();
    await this.page.getByRole('menuitem', { name: new RegExp(`^${title}`) }).click();
    await this.opened();
  }

  async dropFile(name: string, bytes: Uint8Array): Promise<void> {
    await drop(this.page, '#canvas', name, bytes);
    await this.opened();
  }

  /** Waits until the mesh that was asked for is there and has its shape. */
  async opened(): Promise<void> {
    await this.page.waitForSelector('[data-act=undo][aria-label^="Undo Open"]');
    await carved(this.page);
  }

  takes(tool: string): Promise<void> {
    return takeTool(this.page, tool);
  }

  /** Clicks the button of that name. */
  async clicks(name: string): Promise<void> {
    await this.page.getByRole('button', { name, exact: true }).click();
  }

  async clicksAt(...places: readonly Place[]): Promise<void> {
    for (const place of places) await this.page.mouse.click(...place);
  }

  /** Drags through places, and waits for what undo calls it. */
  async drags(entry: string, ...places: readonly Place[]): Promise<void> {
    await drag(this.page, ...places);
    await done(this.page, entry);
  }

  /** Sets a slider of the tool’s options or of the panel to a share of its travel, with a press on it. */
  async slides(label: string, share: number): Promise<void> {
    const box = (await this.page.getByLabel(label, { exact: true }).first().boundingBox())!;
    await this.page.mouse.click(box.x + 8 + share * (box.width - 16), box.y + box.height / 2);
    await this.rests();
  }

  async types(label: string, value: string): Promise<void> {
    const field = this.page.getByLabel(label, { exact: true });
    await field.fill(value);
    await field.press('Enter');
    await this.rests();
  }

  async rests(): Promise<void> {
    await this.page.waitForSelector('whittle-status[data-activity=idle]');
  }
}
