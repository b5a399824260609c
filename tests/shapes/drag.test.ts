import { expect, test } from 'vitest';
import { row } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { farthest } from '../benchmarks/numbers.ts';
import { type Case, caseOf, meshed } from './cases.ts';
import { stretched } from './gestures.ts';
import type { Shape } from './shape.ts';
import { dragged, reshaped } from './solved.ts';
import { diagonalOf } from './surface-facts.ts';

/** Places on the straight way of a gesture. */
function way(shape: Shape, { gestures }: Case, gesture: string, count: number): Handles[] {
  const { vertices, targets } = stretched(shape, gestures[gesture]!);
  return Array.from({ length: count }, (_, k) => {
    const share = (k + 1) / count;
    const partly = targets.map((target, i) => {
      const [x, y, z] = row(shape.positions, vertices[i]!);
      return [x + share * (target[0] - x), y + share * (target[1] - y), z + share * (target[2] - z)] as const;
    });
    return { vertices, targets: partly };
  });
}

test.each([
  ['drilled plate', 'lengthen'],
  ['bracket', 'raise'],
  ['rounded box', 'lengthen'],
  ['chair', 'raise'],
] as const)('%s, %s: where a drag rests the shape is that of a run from rest', async (name, gesture) => {
  const shape = meshed(caseOf(name), 2);
  const places = way(shape, caseOf(name), gesture, 4);
  const ends = await dragged(shape, places);
  for (const [i, handles] of places.entries()) {
    const { positions } = await reshaped(shape, handles);
    expect(ends[i]).toEqual(positions);
  }
});

test('an answer on the way of a drag is near a run from rest', async () => {
  const bracket = caseOf('bracket');
  const shape = meshed(bracket, 2);
  const places = way(shape, bracket, 'raise', 30);
  const answers = await dragged(shape, places, 24);
  for (const i of [9, 19, 29]) {
    const { positions } = await reshaped(shape, places[i]!);
    expect(farthest(answers[i]!, positions) / diagonalOf(shape.positions)).toBeLessThan(0.01);
  }
});
