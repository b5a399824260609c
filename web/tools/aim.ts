import type { Aim } from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Hit } from '../../src/viewer/picking/picking.ts';
import type { ScreenMap } from './screen-map.ts';

/** Pixels within which a line of the shape is meant: fingers are less exact. */
export const reachOf = { mouse: 7, pen: 9, touch: 18 } as const;

/** @param reach pixels from the pointer within which a line is meant; 0 for none */
export function aimAt(
  { face, weights }: Hit,
  { x, y }: Pick<CanvasPointer, 'x' | 'y'>,
  map: ScreenMap,
  reach: number,
): Aim {
  return { face, weights: [...weights], pointer: [x, y], project: map.place, reach };
}
