import { MOUSE } from 'three';
import type { Box } from './box.ts';
import type { CanvasTool } from './canvas-tool.ts';
import { KeyboardPointer } from './keyboard-pointer.ts';
import { Layers } from './layers/layers.ts';
import { Picking } from './picking/picking.ts';
import { PointerRouter } from './pointer-router.ts';
import type { Viewer } from './viewer.ts';

/** Makes a viewer one that can be touched: what a pointer is over, what tools draw there, and whose a gesture is. */
export class Interaction {
  readonly viewer: Viewer;
  readonly picking: Picking;
  readonly layers: Layers;
  readonly #router: PointerRouter;
  readonly #keyboard: KeyboardPointer;
  readonly #sizes: ResizeObserver;

  constructor(viewer: Viewer) {
    this.viewer = viewer;
    this.picking = new Picking(viewer);
    this.layers = new Layers(viewer);
    this.#router = new PointerRouter(viewer.canvas);
    this.#keyboard = new KeyboardPointer(viewer.canvas, () => this.#router.tool);
    this.#sizes = new ResizeObserver(() => {
      this.layers.resize(viewer.canvas.clientWidth, viewer.canvas.clientHeight);
      viewer.invalidate();
    });
    this.#sizes.observe(viewer.canvas);
    // While a tool has the first button the view is turned by the middle one, which is the wheel.
    viewer.space.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.ROTATE, RIGHT: MOUSE.PAN };
  }

  /** A tool's gesture is under way. */
  get isBusy(): boolean {
    return this.#router.isBusy || this.#keyboard.isPressed;
  }

  /** Puts a tool in the hand, or with null the camera. What the tool before it drew is its own to take away. */
  setTool(tool: CanvasTool | null): void {
    if (tool) this.picking.want();
    this.#keyboard.hide();
    this.viewer.holdView(tool !== null);
    this.#router.tool = tool;
  }

  /** Keeps tools to a part of the canvas; outside, gestures are the camera's. Null for all of it. */
  keepWithin(box: Box | null): void {
    const before = this.#router.within;
    this.#keyboard.within = this.#router.within = box;
    // Where the cross is now may be outside.
    if ((before === null) !== (box === null)) this.#keyboard.hide();
  }

  /** Takes back the gesture that is under way. @returns whether there was one */
  cancel(): boolean {
    return this.#router.cancel() || this.#keyboard.cancel();
  }

  dispose(): void {
    this.#sizes.disconnect();
    this.#keyboard.dispose();
    this.#router.dispose();
    this.picking.dispose();
    this.layers.dispose();
  }
}
