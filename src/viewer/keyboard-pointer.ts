import { type Box, middleOf } from './box.ts';
import type { CanvasPointer, CanvasTool } from './canvas-tool.ts';

/** CSS pixels for a press of an arrow key; with Shift four times as far. */
const stride = 12;

const ways: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/**
 * A pointer for those who have none: on the focused canvas the arrow keys walk a cross, Enter presses until it is let go, and Escape
 * takes back what was pressed.
 */
export class KeyboardPointer {
  /** Where the cross is; null while it is not in use. */
  place: { readonly x: number; readonly y: number } | null = null;
  /** Where it walks; null for all of the canvas. */
  within: Box | null = null;
  #isPressed = false;
  readonly #canvas: HTMLElement;
  readonly #cross: HTMLElement;
  readonly #tool: () => CanvasTool | null;
  readonly #off = new AbortController();

  /** @param tool the one in the hand; while there is none the keys are the camera's */
  constructor(canvas: HTMLElement, tool: () => CanvasTool | null) {
    this.#canvas = canvas;
    this.#tool = tool;
    this.#cross = canvas.ownerDocument.createElement('div');
    this.#cross.className = 'canvas-cross';
    this.#cross.hidden = true;
    this.#cross.ariaHidden = 'true';
    canvas.after(this.#cross);
    const { signal } = this.#off;
    // It comes before the camera, whose keys these are while there is no tool.
    canvas.addEventListener('keydown', this.#down, { signal, capture: true });
    canvas.addEventListener('keyup', this.#up, { signal });
    canvas.addEventListener('blur', () => this.hide(), { signal });
    canvas.addEventListener('pointermove', () => this.#isPressed || this.hide(), { signal });
  }

  get isPressed(): boolean {
    return this.#isPressed;
  }

  hide(): void {
    if (this.#isPressed) this.cancel();
    this.place = null;
    this.#cross.hidden = true;
  }

  /** @returns whether something was pressed */
  cancel(): boolean {
    if (!this.#isPressed) return false;
    this.#isPressed = false;
    this.#tool()?.cancel();
    return true;
  }

  dispose(): void {
    this.#off.abort();
    this.#cross.remove();
  }

  readonly #down = (event: KeyboardEvent): void => {
    const tool = this.#tool();
    const way = ways[event.key];
    if (!tool || event.ctrlKey || event.metaKey || (!way && event.key !== 'Enter')) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (way) this.#walk(tool, way, event);
    else if (!event.repeat) this.#isPressed = tool.press(this.#pointer(event));
  };

  readonly #up = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' || !this.#isPressed) return;
    this.#isPressed = false;
    this.#tool()?.release(this.#pointer(event));
  };

  #walk(tool: CanvasTool, [x, y]: readonly [number, number], event: KeyboardEvent): void {
    const from = this.#here;
    const step = event.shiftKey && !this.#isPressed ? 4 * stride : stride;
    const { left, top, width, height } = this.#reach;
    const inside = (value: number, low: number, size: number) =>
      Math.min(low + size - 1, Math.max(low, value));
    this.place = { x: inside(from.x + x * step, left, width), y: inside(from.y + y * step, top, height) };
    this.#cross.hidden = false;
    this.#cross.style.translate = `${this.place.x}px ${this.place.y}px`;
    const pointer = this.#pointer(event);
    if (this.#isPressed) tool.move(pointer);
    else tool.hover?.(pointer);
  }

  get #here(): { x: number; y: number } {
    return this.place ?? middleOf(this.#reach);
  }

  get #reach(): Box {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    return this.within ?? { left: 0, top: 0, width, height };
  }

  #pointer({ shiftKey, ctrlKey, metaKey, altKey }: KeyboardEvent): CanvasPointer {
    return {
      ...this.#here,
      kind: 'mouse',
      pressure: 1,
      shift: shiftKey,
      ctrl: ctrlKey || metaKey,
      alt: altKey,
    };
  }
}
