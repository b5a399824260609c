import type { Page } from 'playwright-core';
import { carved, drop } from '../browser/support/browser.ts';
import { type SavedFile, saved } from '../browser/support/downloads.ts';
import { done, drag, type Place, takeTool } from '../browser/support/hands.ts';

/** What a person does on the page: presses, moves, lets go, and types. Nothing here calls into the page’s code. */
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

  /** Takes a tool and waits until the view has made room for its options. */
  async takes(tool: string): Promise<void> {
    await takeTool(this.page, tool);
  }

  /** Clicks the button of that name and waits for the shape that it leads to. */
  async clicks(name: string): Promise<void> {
    await this.page.getByRole('button', { name, exact: true }).click();
    await this.rests();
  }

  /** Chooses one of several faces that lie side by side, or a method by its picture. */
  async chooses(title: string): Promise<void> {
    await this.page.locator('fieldset label').getByText(title, { exact: true }).click();
    await this.rests();
  }

  /** Chooses one of several in a list that opens. */
  async picks(label: string, option: string): Promise<void> {
    await this.page
      .locator('label', { hasText: label })
      .locator('select')
      .first()
      .selectOption({ label: option });
    await this.rests();
  }

  /** Opens a fold. */
  unfolds(title: string): Promise<void> {
    return this.page.locator('summary').getByText(title, { exact: true }).click();
  }

  ticks(label: string): Promise<void> {
    return this.page.getByLabel(label, { exact: true }).check();
  }

  async clicksAt(...places: readonly Place[]): Promise<void> {
    for (const place of places) await this.page.mouse.click(...place);
  }

  /** Drags through places, and waits for what undo calls it. */
  async drags(entry: string, ...places: readonly Place[]): Promise<void> {
    await drag(this.page, ...places);
    await done(this.page, entry);
  }

  /** Drags through places where that changes nothing of the shape: the view turns, or something is selected. */
  async sweeps(...places: readonly Place[]): Promise<void> {
    await drag(this.page, ...places);
    await this.rests();
  }

  /** Goes further away with the wheel. */
  async zooms(notches: number): Promise<void> {
    await this.page.mouse.move(500, 650);
    for (let k = 0; k < notches; k++) await this.page.mouse.wheel(0, 100);
    await this.rests();
  }

  /** Selects what a line around it encloses, the far side too. */
  async lassoes(...places: readonly Place[]): Promise<void> {
    await this.takes('Select');
    await this.chooses('Lasso');
    await this.ticks('Far side too');
    await this.sweeps(...places);
    await this.page.locator('.selected').filter({ hasText: 'selected' }).waitFor();
  }

  /** Strokes over the ball of directions, through places on it from −1 to 1. */
  async strokesBall(...places: readonly Place[]): Promise<void> {
    const ball = this.page.locator('whittle-strength-ball canvas');
    await ball.scrollIntoViewIfNeeded();
    const box = (await ball.boundingBox())!;
    const inWindow = ([x, y]: Place): Place => [
      box.x + (box.width * (1 + 0.92 * x)) / 2,
      box.y + (box.height * (1 - 0.92 * y)) / 2,
    ];
    await this.drags('Paint strength', ...places.map(inWindow));
  }

  /** The ball of directions as the picture that a recipe names. */
  async savesBall(): Promise<SavedFile> {
    await this.takes('Paint');
    const file = await saved(this.page, () => this.clicks('Save'));
    await this.takes('Turn');
    return { ...file, name: 'strength.png' };
  }

  /** Sets a slider of the tool’s options or of the panel to a share of its travel, with a press on it. */
  async slides(label: string, share: number): Promise<void> {
    const slider = this.page.getByLabel(label, { exact: true }).first();
    await slider.scrollIntoViewIfNeeded();
    const box = (await slider.boundingBox())!;
    await this.page.mouse.click(box.x + 8 + share * (box.width - 16), box.y + box.height / 2);
    await this.rests();
  }

  async types(label: string, value: string): Promise<void> {
    const field = this.page.getByLabel(label, { exact: true });
    await field.fill(value);
    await field.press('Enter');
    await this.rests();
  }

  /** Types on the canvas, as one moves a group by keys, and waits for what undo calls it. */
  async keys(entry: string, text: string): Promise<void> {
    await this.page.keyboard.type(text);
    await this.page.keyboard.press('Enter');
    await done(this.page, entry);
  }

  async rests(): Promise<void> {
    await this.page.waitForSelector('whittle-status[data-activity=idle]');
  }
}
