import { describe, expect, test } from 'vitest';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import { PlaneDrag, type PlaneParts } from '../../web/tools/plane-grips.ts';

const pointer = (x: number, y = 0): CanvasPointer => ({
  ...{ x, y, kind: 'mouse', pressure: 1, shift: false, ctrl: false, alt: false },
});

/** A plane across a normal of any length, at 3 of its lengths, looked at along −z with a pixel a unit. */
function taken(normal: readonly [number, number, number]) {
  const plane = { vertices: [0], normal, offset: 3 };
  const log: string[] = [];
  const frames: (() => void)[] = [];
  const parts = {
    soon: (run: () => void) => frames.push(run),
    planes: {
      planes: [plane],
      shift: (index: number, offset: number, isDone: boolean) =>
        log.push(`${isDone ? 'keep' : 'show'} ${index} ${offset.toFixed(6)}`),
      cancel: () => log.push('take back'),
    },
    interaction: {
      picking: {
        ray: ({ x, y }: CanvasPointer) => ({ origin: [x, y, 9], direction: [0, 0, -1] }),
      },
    },
  } as unknown as PlaneParts;
  const size = Math.hypot(...normal);
  const sheet = { center: [0, 0, 0], normal: normal.map((value) => value / size), reach: 1 } as const;
  const drag = new PlaneDrag(parts, {
    index: 0,
    sheet: sheet as unknown as ConstructorParameters<typeof PlaneDrag>[1]['sheet'],
    pointer: pointer(10),
  });
  const picture = () => {
    for (const run of frames.splice(0)) run();
  };
  return { drag, log, picture };
}

describe('a plane that is dragged by its arrow', () => {
  test('goes as far as the pointer goes along it, in lengths of its normal', () => {
    for (const [normal, expected] of [
      [[1, 0, 0], 3.5],
      [[-4, 0, 0], 1],
      [[0, 2, 0], 3 + 0.25 * 2],
      // Half towards the one who looks: a pixel on the screen is √2 along it.
      [[1, 0, 1], 3 + 0.5 * Math.SQRT2 * Math.SQRT2],
    ] as const) {
      const { drag, log } = taken(normal);
      drag.release(pointer(10.5, 0.25));
      expect(log).toEqual([`keep 0 ${expected.toFixed(6)}`]);
    }
  });

  test('shows the newest place once a picture, and keeps the last', () => {
    const { drag, log, picture } = taken([1, 0, 0]);
    drag.move(pointer(11));
    drag.move(pointer(12));
    picture();
    drag.move(pointer(13));
    drag.release(pointer(14));
    picture();
    expect(log).toEqual(['show 0 5.000000', 'keep 0 7.000000']);
  });

  test('leaves nothing where it is let go at where it was taken, or taken back', () => {
    const click = taken([1, 0, 0]);
    click.drag.release(pointer(10));
    expect(click.log).toEqual([]);
    const back = taken([1, 0, 0]);
    back.drag.move(pointer(12));
    back.picture();
    back.drag.release(pointer(10));
    expect(back.log).toEqual(['show 0 5.000000', 'take back']);
    const escaped = taken([1, 0, 0]);
    escaped.drag.move(pointer(12));
    escaped.drag.cancel();
    escaped.picture();
    expect(escaped.log).toEqual([]);
  });
});
