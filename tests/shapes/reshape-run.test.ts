import { describe, expect, test } from 'vitest';
import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import { farthest } from '../benchmarks/numbers.ts';
import { caseOf, meshed } from './cases.ts';
import { stretched } from './gestures.ts';
import { apart, sameness } from './sameness.ts';
import type { Shape } from './shape.ts';
import { reshaped } from './solved.ts';
import { lateMoves } from './stillness.ts';
import { diagonalOf } from './surface-facts.ts';

const shapes = ['drilled plate', 'bracket', 'pin in a hole'].map((name) => meshed(caseOf(name), 2));
const diagonal = (shape: Shape) => diagonalOf(shape.positions);
const pulled = (shape: Shape) => stretched(shape, caseOf(shape.name).gestures.lengthen!);

describe.each(shapes)('$name', (shape) => {
  test('gives the same bits again', async () => {
    const [a, b] = [await reshaped(shape, pulled(shape)), await reshaped(shape, pulled(shape))];
    expect(a.positions).toEqual(b.positions);
    expect(a.iterations).toBe(b.iterations);
    expect(farthest(a.positions, shape.positions)).toBeGreaterThan(1);
  });

  test('gives the bits that came in where no handle is to move', async () => {
    const { vertices } = pulled(shape);
    const still = { vertices, targets: vertices.map((v) => row(shape.positions, v)) };
    expect((await reshaped(shape, still)).positions).toEqual(shape.positions);
  });

  test('is scaled as a whole in 3D ALUP where handles are', async () => {
    const larger = ([x, y, z]: Vec3): Vec3 => [1.5 * x, 1.5 * y, 1.5 * z];
    const { vertices } = pulled(shape);
    const handles = { vertices, targets: vertices.map((v) => larger(row(shape.positions, v))) };
    const { positions } = await reshaped(shape, handles, { variant: 'alup' });
    const scaled = shape.positions.map((x) => 1.5 * x);
    expect(farthest(positions, scaled) / diagonal(shape)).toBeLessThan(0.002);
  });
});

test.each([
  ['nut', 'widen'],
  ['ring', 'pull'],
  ['wineglass', 'raise by points'],
  ['pin in a hole, with a gap', 'lengthen'],
] as const)('%s, %s: the answer is the same wherever it lies, and in any order', async (name, gesture) => {
  const shape = meshed(caseOf(name), 2);
  const off = await apart(shape, stretched(shape, caseOf(name).gestures[gesture]!));
  expect(off.turned).toBeLessThan(sameness.turned);
  expect(off.shuffled).toBeLessThan(sameness.shuffled);
});

test.each([
  ['drilled plate', 'lengthen', 1],
  ['chair', 'raise', 1],
  ['chair', 'widen', 2],
  ['bottle', 'raise', 2],
  ['capsule', 'lengthen by points', 1],
  ['chamfered box', 'lengthen', 2],
  ['rounded box', 'lengthen', 2],
] as const)(
  '%s, %s, edges ×%d: the last fifth of the iterations moves nothing that is seen',
  async (name, gesture, scale) => {
    const shape = meshed(caseOf(name), scale);
    const ways: Float64Array[] = [];
    await reshaped(shape, stretched(shape, caseOf(name).gestures[gesture]!), {}, (at) =>
      ways.push(at.slice()),
    );
    expect(ways.length).toBeGreaterThan(5);
    expect(ways.length).toBeLessThan(100);
    expect(lateMoves(shape, ways).outOfFaces).toBeLessThan(0.002);
  },
);
