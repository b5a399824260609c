import type { CanvasTool } from '../../src/viewer/canvas-tool.ts';

/** What one can do on the canvas; `turn` leaves it to the camera. */
export type ToolId = 'turn' | 'select' | 'move' | 'lines' | 'paint' | 'cube';

/** Something to work on the mesh with. It draws its layers while it is in the hand and takes them away when it leaves it. */
export interface Tool extends CanvasTool {
  /** It comes into the hand. */
  enter(): void;
  leave(): void;
  /** A key is pressed that no field wants. @returns whether the tool has used it */
  key?(event: KeyboardEvent): boolean;
}
