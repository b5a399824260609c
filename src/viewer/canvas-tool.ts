/** Where a pointer is on the canvas, and what is held down with it. */
export interface CanvasPointer {
  /** CSS pixels from the canvas's top left corner. */
  readonly x: number;
  readonly y: number;
  readonly kind: 'mouse' | 'pen' | 'touch';
  /** 0 to 1; 1 where the device does not feel it. */
  readonly pressure: number;
  readonly shift: boolean;
  /** Ctrl, or Cmd on a Mac. */
  readonly ctrl: boolean;
  readonly alt: boolean;
}

/**
 * What the first button, a pen's tip or one finger does on the canvas. It is asked before the camera is: a gesture that it does not
 * take turns the view.
 */
export interface CanvasTool {
  /** CSS cursor over the canvas; default that of the camera. */
  readonly cursor?: string;
  /** A pointer moved with nothing pressed; null once it has left. Fingers do not hover. */
  hover?(pointer: CanvasPointer | null): void;
  /** @returns whether the tool takes the gesture that begins here */
  press(pointer: CanvasPointer): boolean;
  move(pointer: CanvasPointer): void;
  release(pointer: CanvasPointer): void;
  /** The gesture was none after all (a second finger, Escape): what it did is taken back. */
  cancel(): void;
}

/** A pointer's place on an element. */
export function canvasPointer(event: PointerEvent, element: Element): CanvasPointer {
  const box = element.getBoundingClientRect();
  const kind = event.pointerType === 'pen' || event.pointerType === 'touch' ? event.pointerType : 'mouse';
  return {
    x: event.clientX - box.left,
    y: event.clientY - box.top,
    kind,
    pressure: kind === 'pen' ? event.pressure : 1,
    shift: event.shiftKey,
    ctrl: event.ctrlKey || event.metaKey,
    alt: event.altKey,
  };
}
