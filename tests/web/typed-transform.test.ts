import { describe, expect, it } from 'vitest';
import { applied } from '../../src/mesh/affine.ts';
import { distance, type Vec3 } from '../../src/mesh/vectors.ts';
import { type PointerWay, TypedTransform } from '../../web/tools/typed-transform.ts';

const pivot: Vec3 = [1, 1, 0];

function typed(keys: string, way: PointerWay | null = null) {
  const transform = new TypedTransform(TypedTransform.kindOf(keys[0]!)!, pivot);
  for (const key of keys.slice(1)) expect(transform.key(key)).toBe(true);
  return { transform, moved: (point: Vec3) => applied(transform.movement(way), point) };
}

function expectNear(actual: Vec3, wanted: Vec3) {
  expect(distance(actual, wanted)).toBeLessThan(1e-9);
}

describe('a transform by keys', () => {
  it('moves by a typed number along an axis', () => {
    const { transform, moved } = typed('gy-1.5');
    expectNear(moved([2, 2, 2]), [2, 0.5, 2]);
    expect(transform.sentence).toBe('Move along y by -1.5');
  });

  it('turns by degrees about an axis through the pivot', () => {
    const { transform, moved } = typed('rz90');
    expectNear(moved([2, 1, 5]), [1, 2, 5]);
    expect(transform.sentence).toBe('Turn about z by 90°');
  });

  it('scales by a factor, along an axis or all around', () => {
    expectNear(typed('sx2').moved([2, 2, 2]), [3, 2, 2]);
    expectNear(typed('s0.5').moved([3, 1, 2]), [2, 1, 1]);
  });

  it('follows the pointer until a number is typed', () => {
    const way: PointerWay = { from: [1, 1, 0], to: [1.5, 1.25, 0], toEye: [0, 0, 1] };
    expectNear(typed('g', way).moved([0, 0, 0]), [0.5, 0.25, 0]);
    expectNear(typed('gx', way).moved([0, 0, 0]), [0.5, 0, 0]);
    expectNear(typed('gx3', way).moved([0, 0, 0]), [3, 0, 0]);
    const quarter: PointerWay = { from: [2, 1, 0], to: [1, 2, 0], toEye: [0, 0, 1] };
    expectNear(typed('r', quarter).moved([2, 1, 7]), [1, 2, 7]);
    // Seen from behind an axis the hand still turns what it sees.
    const behind: PointerWay = { ...quarter, toEye: [0, 0, -1] };
    expectNear(typed('rz', behind).moved([2, 1, 7]), [1, 2, 7]);
    const twice: PointerWay = { from: [2, 1, 0], to: [3, 1, 0], toEye: [0, 0, 1] };
    expectNear(typed('s', twice).moved([1, 2, 0]), [1, 3, 0]);
  });

  it('takes digits back, drops an axis that is pressed again, and leaves other keys alone', () => {
    const { transform, moved } = typed('gxx12');
    transform.key('Backspace');
    expect(transform.sentence).toBe('Move by 1');
    expectNear(moved([0, 0, 0]), [1, 0, 0]);
    expect(transform.key('q')).toBe(false);
    expect(TypedTransform.kindOf('k')).toBeUndefined();
  });
});
