import type { Extent } from '../mesh/extent.ts';

/**
 * The frame the viewer draws in: the box of what matters of a mesh centred at the origin with half its diagonal as the unit, so that cameras,
 * lights and shadows are the same for a millimetre part and a city, and single precision is enough on the GPU.
 */
export interface ViewFrame {
  readonly center: readonly [number, number, number];
  /** View units per file unit. */
  readonly scale: number;
}

/** @param extent in the file's units; one without a size gets scale 1 */
export function frameOf({ min, max, diagonal }: Extent): ViewFrame {
  const middle = (axis: 0 | 1 | 2): number => min[axis] + (max[axis] - min[axis]) / 2;
  const usable = Number.isFinite(diagonal) && diagonal > 0;
  return { center: [middle(0), middle(1), middle(2)], scale: usable ? 2 / diagonal : 1 };
}

/** Writes positions of the file (#P×3) in view units into a GPU array of the same length. */
export function toView(positions: Float64Array, frame: ViewFrame, into: Float32Array): void {
  const [cx, cy, cz] = frame.center;
  const s = frame.scale;
  for (let i = 0; i < into.length; i += 3) {
    into[i] = (positions[i]! - cx) * s;
    into[i + 1] = (positions[i + 1]! - cy) * s;
    into[i + 2] = (positions[i + 2]! - cz) * s;
  }
}
