import { type Box, isInside } from './box.ts';
import { type CanvasTool, canvasPointer } from './canvas-tool.ts';

/**
 * Gives each gesture on the canvas to the tool, or else to the camera. It listens before the camera's controls do and lets through
 * what is theirs: other buttons, a second finger, everything while Space is held, and what the tool does not take.
 */
export class PointerRouter {
  readonly #canvas: HTMLElement;
  readonly #off = new AbortController();
  #tool: CanvasTool | null = null;
  /** The event that began the gesture which the tool has taken. */
  #taken: PointerEvent | null = null;
  #fingers = new Set<number>();
  #isSpaceDown = false;
  /** Where gestures may be the tool's; null for all of the canvas. */
  within: Box | null = null;

  constructor(canvas: HTMLElement) {
    this.#canvas = canvas;
    const listen = (type: string, does: (event: PointerEvent) => void) =>
      canvas.addEventListener(type, does as EventListener, { capture: true, signal: this.#off.signal });
    listen('pointerdown', this.#down);
    listen('pointermove', this.#move);
    listen('pointerup', this.#up);
    listen('pointercancel', this.#lost);
    listen('pointerleave', this.#leave);
    this.#watchSpace();
  }

  get tool(): CanvasTool | null {
    return this.#tool;
  }

  set tool(tool: CanvasTool | null) {
    if (tool === this.#tool) return;
    this.cancel();
    this.#tool?.hover?.(null);
    this.#tool = tool;
    this.#showCursor();
  }

  get isBusy(): boolean {
    return this.#taken !== null;
  }

  /** Takes back the gesture that is under way, if there is one. */
  cancel(): boolean {
    if (!this.#taken) return false;
    this.#letGo();
    this.#tool?.cancel();
    return true;
  }

  dispose(): void {
    this.tool = null;
    this.#off.abort();
  }

  readonly #down = (event: PointerEvent): void => {
    if (!event.isTrusted && handedOver.has(event)) return;
    if (event.pointerType === 'touch') this.#fingers.add(event.pointerId);
    if (this.#taken) {
      this.#downWhileBusy(event);
      return;
    }
    const isFree = event.button === 0 && !this.#isSpaceDown && this.#fingers.size < 2;
    if (!this.#tool || !isFree || !this.#isWithin(event)) return;
    if (!this.#tool.press(canvasPointer(event, this.#canvas))) return;
    this.#taken = event;
    this.#keep(event);
    this.#canvas.setPointerCapture(event.pointerId);
  };

  /** A second finger means the camera, for both; another button means nothing. */
  #downWhileBusy(event: PointerEvent): void {
    const first = this.#taken!;
    if (event.pointerType !== 'touch' || first.pointerType !== 'touch') {
      this.#keep(event);
      return;
    }
    this.cancel();
    const { pointerId, pointerType, clientX, clientY, isPrimary } = first;
    const again = new PointerEvent('pointerdown', {
      ...{ pointerId, pointerType, clientX, clientY, isPrimary, bubbles: true, cancelable: true },
      ...{ button: 0, buttons: 1 },
    });
    handedOver.add(again);
    this.#canvas.dispatchEvent(again);
  }

  readonly #move = (event: PointerEvent): void => {
    if (this.#taken) {
      if (event.pointerId === this.#taken.pointerId) this.#tool?.move(canvasPointer(event, this.#canvas));
      this.#keep(event);
    } else if (event.buttons === 0 && event.pointerType !== 'touch')
      this.#tool?.hover?.(this.#isWithin(event) ? canvasPointer(event, this.#canvas) : null);
  };

  #isWithin(event: PointerEvent): boolean {
    if (!this.within) return true;
    const { x, y } = canvasPointer(event, this.#canvas);
    return isInside(this.within, x, y);
  }

  readonly #up = (event: PointerEvent): void => {
    this.#fingers.delete(event.pointerId);
    if (!this.#taken || event.pointerId !== this.#taken.pointerId) return;
    this.#keep(event);
    this.#letGo();
    this.#tool?.release(canvasPointer(event, this.#canvas));
  };

  readonly #lost = (event: PointerEvent): void => {
    this.#fingers.delete(event.pointerId);
    if (event.pointerId === this.#taken?.pointerId) this.cancel();
  };

  readonly #leave = (event: PointerEvent): void => {
    if (event.pointerType === 'touch') this.#fingers.delete(event.pointerId);
    if (!this.#taken) this.#tool?.hover?.(null);
  };

  /** Keeps an event from the camera. */
  #keep(event: PointerEvent): void {
    event.stopImmediatePropagation();
  }

  #letGo(): void {
    const { pointerId } = this.#taken!;
    this.#taken = null;
    if (this.#canvas.hasPointerCapture(pointerId)) this.#canvas.releasePointerCapture(pointerId);
  }

  #watchSpace(): void {
    const { signal } = this.#off;
    const set = (down: boolean) => {
      if (down === this.#isSpaceDown) return;
      this.#isSpaceDown = down;
      this.#showCursor();
    };
    const isOnPage = ({ target }: KeyboardEvent) =>
      target === this.#canvas || target === document.body || target === document;
    const page = this.#canvas.ownerDocument;
    page.addEventListener('keydown', (event) => event.key === ' ' && isOnPage(event) && set(true), {
      signal,
    });
    page.addEventListener('keyup', (event) => event.key === ' ' && set(false), { signal });
    page.defaultView?.addEventListener('blur', () => set(false), { signal });
  }

  #showCursor(): void {
    this.#canvas.style.cursor = this.#isSpaceDown ? '' : (this.#tool?.cursor ?? '');
  }
}

/** Events that were made again for the camera. */
const handedOver = new WeakSet<Event>();
