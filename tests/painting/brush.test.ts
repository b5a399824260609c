import { expect, test } from 'vitest';
import { distance } from '../../src/mesh/vectors.ts';
import { Coverage, falloff, Stroke } from '../../src/painting/index.ts';

test('a brush is full in its core, nothing at its rim, and falls between', () => {
  const tip = { radius: 2, hardness: 0.5 };
  expect([0, 1, 2, 3].map((away) => falloff(away, tip))).toEqual([1, 1, 0, 0]);
  expect(falloff(1.5, tip)).toBeCloseTo(0.5);
  expect(falloff(1.9, { radius: 2, hardness: 1 })).toBe(1);
});

test('a stroke leaves no gaps between two sights of the pointer', () => {
  const stroke = new Stroke(0.1);
  const touches = [...stroke.to([0, 0, 0]), ...stroke.to([1, 0, 0])];
  for (let k = 1; k < touches.length; k++)
    expect(distance(touches[k - 1]!, touches[k]!)).toBeLessThanOrEqual(0.1 + 1e-12);
  expect(touches.at(-1)).toEqual([1, 0, 0]);
});

test('a stroke is no stronger where it crosses itself, and as strong as it was pressed hardest', () => {
  // Places along a line.
  const coverage = new Coverage<number>(9, (point, radius, visit) => {
    for (let place = 0; place < 9; place++)
      if (Math.abs(place - point) < radius) visit(place, Math.abs(place - point));
  });
  const tip = { radius: 3, hardness: 0 };
  expect(coverage.touch(4, tip, 0.5)).toEqual([2, 3, 4, 5, 6]);
  expect(coverage.share[4]).toBe(0.5);
  expect(coverage.touch(4, tip, 0.5)).toEqual([]);
  expect(coverage.touch(4, tip, 1)).toEqual([2, 3, 4, 5, 6]);
  expect(coverage.share[4]).toBe(1);
  const before = coverage.share.slice();
  expect(coverage.touch(4, tip, 0.2)).toEqual([]);
  expect(coverage.share).toEqual(before);
});
