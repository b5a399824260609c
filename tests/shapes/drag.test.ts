import { expect, test } from 'vitest';
import { row } from '../../src/mesh/vectors.ts';
import { caseOf, meshed } from './cases.ts';
import { stretched } from './gestures.ts';
import { dragged, reshaped } from './solved.ts';

test.each([
  ['drilled plate', 'lengthen'],
  ['bracket', 'raise'],
  ['rounded box', 'lengthen'],
  ['chair', 'raise'],
] as const)('%s, %s: where a drag rests the shape is that of a run from rest', async (name, gesture) => {
  const shape = meshed(caseOf(name), 2);
  const { vertices, targets } = stretched(shape, caseOf(name).gestures[gesture]!);
  const places = [0.25, 0.5, 0.75, 1].map((share) => ({
    vertices,
    targets: targets.map((target, i) => {
      const [x, y, z] = row(shape.positions, vertices[i]!);
      return [x + share * (target[0] - x), y + share * (target[1] - y), z + share * (target[2] - z)] as const;
    }),
  }));
  const ends = await dragged(shape, places);
  for (const [i, handles] of places.entries()) {
    const { positions } = await reshaped(shape, handles);
    expect(ends[i]).toEqual(positions);
  }
});
