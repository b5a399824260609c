/**
 * The frame the viewer draws in: the file's box centred at the origin with half its diagonal as the unit, so that cameras,
 * lights and shadows are the same for a millimetre part and a city, and single precision is enough on the GPU.
 */
export interface ViewFrame {
  readonly center: readonly [number, number, number];
  /** View units per file unit. */
  readonly scale: number;
}

/** @param positions #P×3 in the file's units; an empty or flat-out degenerate box gets scale 1 */
export function frameOf(positions: Float64Array): ViewFrame {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    const x = positions[i]!;
    if (x < min[axis]!) min[axis] = x;
    if (x > max[axis]!) max[axis] = x;
  }
  const half = (axis: number) => (max[axis]! - min[axis]!) / 2;
  const radius = Math.hypot(half(0), half(1), half(2));
  const usable = Number.isFinite(radius) && radius > 0;
  const middle = (axis: number) => (Number.isFinite(min[axis]!) ? min[axis]! + half(axis) : 0);
  return { center: [middle(0), middle(1), middle(2)], scale: usable ? 1 / radius : 1 };
}

/** How far the farthest point is from the origin. @param positions #P×3 */
export function reachOf(positions: Float32Array): number {
  let square = 0;
  for (let p = 0; p < positions.length; p += 3)
    square = Math.max(square, positions[p]! ** 2 + positions[p + 1]! ** 2 + positions[p + 2]! ** 2);
  return Math.sqrt(square);
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
