import { expect, it } from 'vitest';
import { framesIn } from '../../web/app/frames.ts';

const inside = { left: 100, top: 50 };

it('one picture has all of it', () => {
  const free = { ...inside, width: 600, height: 400 };
  expect(framesIn(free, 1)).toEqual([free]);
});

it('pictures stand side by side where it is wide, one above the other where it is high, and four in a square', () => {
  const places = (width: number, height: number, count: number) =>
    framesIn({ ...inside, width, height }, count).map(({ left, top }) => [left, top]);
  expect(places(808, 300, 2)).toEqual([
    [100, 50],
    [508, 50],
  ]);
  expect(places(300, 808, 2)).toEqual([
    [100, 50],
    [100, 458],
  ]);
  expect(places(608, 608, 4)).toEqual([
    [100, 50],
    [408, 50],
    [100, 358],
    [408, 358],
  ]);
  expect(framesIn({ ...inside, width: 808, height: 300 }, 2, true).map(({ top }) => top)).toEqual([50, 204]);
});

it('pictures are of one size, apart from each other and inside', () => {
  for (const count of [2, 3, 4]) {
    const frames = framesIn({ ...inside, width: 514, height: 690 }, count);
    expect(frames).toHaveLength(count);
    for (const { left, top, width, height } of frames) {
      expect([width, height]).toEqual([frames[0]!.width, frames[0]!.height]);
      expect(left + width).toBeLessThanOrEqual(100 + 514 + 1e-9);
      expect(top + height).toBeLessThanOrEqual(50 + 690 + 1e-9);
    }
    for (const [a, b] of frames.flatMap((one, k) =>
      frames.slice(k + 1).map((other) => [one, other] as const),
    ))
      expect(a.left + a.width < b.left || a.top + a.height < b.top || b.left + b.width < a.left).toBe(true);
  }
});
