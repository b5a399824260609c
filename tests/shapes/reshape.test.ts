import { describe, expect, test } from 'vitest';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { asDrawn, caseOf, meshed } from './cases.ts';
import { stretched, turnedHandles } from './gestures.ts';
import { offSize, shortfalls, wantedRatio } from './limits.ts';
import { Judge, type Measures } from './measures.ts';
import { oblique, type Shape, turned } from './shape.ts';
import { reshaped } from './solved.ts';

type Row = [shape: string, gesture: string, scale: number];

/** What holds all limits; docs/reshaping.md has what does not. */
const rows: Row[] = [
  ...[0.5, 1, 2].map((scale): Row => ['cylinder', 'lengthen by points', scale]),
  ['cylinder', 'shorten', 2],
  ['ruled cylinder', 'lengthen by points', 2],
  ['capsule', 'lengthen by points', 1],
  ['dumbbell', 'lengthen', 2],
  ['dumbbell', 'lengthen by points', 1],
  ['angle', 'lengthen', 2],
  ['angle', 'shorten', 2],
  ['angle', 'raise', 2],
  ['table', 'raise', 2],
  ['table', 'widen', 2],
  ['lamp', 'raise by points', 1],
  ['wineglass', 'raise', 2],
  ['wineglass', 'raise by points', 1],
  ['ball', 'pull', 2],
  ['hemisphere', 'pull', 2],
  ['ring', 'pull', 2],
  ['drilled plate', 'lengthen', 1],
  ['drilled plate', 'widen', 1],
  ['chamfered box', 'lengthen', 2],
  ['chamfered box', 'widen', 2],
  ['rounded box', 'lengthen', 1],
  ['bracket', 'lengthen', 1],
  ['bracket', 'widen', 2],
  ['bracket', 'raise', 2],
  ['pegs on a board', 'lengthen', 2],
  ['pegs on a board', 'shorten', 1],
  ['pegs on a board', 'widen', 2],
  ['nut', 'widen', 2],
  ['nut', 'raise', 2],
  ['mug', 'raise', 2],
  ['mug', 'lower', 2],
  ['bottle', 'raise', 2],
  ['bottle', 'lower', 2],
  ['pin in a hole', 'lengthen', 2],
  ['pin in a hole, with a gap', 'lengthen', 2],
  ['block on a slab, touching', 'lengthen', 2],
  ['block on a slab, sunk', 'lengthen', 2],
  ['block on a slab, with a gap', 'lengthen', 2],
  ...[5, 6, 8, 12].map((sides): Row => [`rod of ${sides} sides`, 'lengthen by points', 2]),
];

async function measured(
  shape: Shape,
  gesture: string,
  values: ParameterValues = {},
  isTurned = false,
): Promise<Measures> {
  const straight = stretched(shape, caseOf(shape.name).gestures[gesture]!);
  const [there, handles] = isTurned
    ? [turned(shape, oblique), turnedHandles(straight, oblique)]
    : [shape, straight];
  return new Judge(there).measure((await reshaped(there, handles, values)).positions, handles);
}

describe('nothing that a person would notice is off', () => {
  test.each(rows)('%s, %s, edges ×%d', async (name, gesture, scale) => {
    const made = caseOf(name);
    const measures = await measured(meshed(made, scale), gesture);
    expect(shortfalls(measures, wantedRatio(made, made.gestures[gesture]!))).toEqual([]);
  });

  test.each([
    ['drilled plate', 'lengthen', 1],
    ['bracket', 'raise', 2],
    ['nut', 'widen', 2],
    ['angle', 'shorten', 2],
  ] as const)('%s, %s, edges ×%d, that lies obliquely', async (name, gesture, scale) => {
    expect(shortfalls(await measured(meshed(caseOf(name), scale), gesture, {}, true))).toEqual([]);
  });

  test.each([
    ['cylinder', 'lengthen by points'],
    ['handset', 'lengthen'],
    ['chamfered box', 'widen'],
    ['rounded box', 'lengthen'],
    ['bracket', 'raise'],
    ['pegs on a board', 'raise'],
    ['nut', 'widen'],
    ['bottle', 'lower'],
    ['rod of 6 sides', 'lengthen by points'],
  ])('%s, %s, with the slivers of a program for construction', async (name, gesture) => {
    expect(shortfalls(await measured(asDrawn(caseOf(name)), gesture))).toEqual([]);
  });
});

test.each([
  ['drilled plate', 'lengthen', 1],
  ['cylinder', 'lengthen by points', 2],
  ['lamp', 'raise by points', 2],
  ['pegs on a board', 'lengthen', 2],
  ['nut', 'widen', 2],
  ['pin in a hole', 'lengthen', 2],
] as const)(
  'round parts grow as the paper has it, and not as we do: %s, %s, edges ×%d',
  async (name, gesture, scale) => {
    const shape = meshed(caseOf(name), scale);
    const [ours, printed] = [
      await measured(shape, gesture),
      await measured(shape, gesture, { reading: 'published' }),
    ];
    const off = ({ rounds }: Measures) => Math.max(...rounds.map((kept) => offSize(kept)));
    expect(off(printed)).toBeGreaterThan(0.1);
    expect(off(ours)).toBeLessThan(0.25 * off(printed));
  },
);
