import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  footing,
  handleGroups,
  movedHandles,
  noHandles,
  outlook,
  spelledOut,
  targetCenter,
  withHandles,
  withoutHandles,
} from '../../src/editor/handle-groups.ts';
import {
  type Affine,
  applied,
  mirrored,
  rotationAbout,
  scalingFrom,
  translation,
} from '../../src/mesh/affine.ts';
import { distance, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { plate } from '../fixtures/shapes.ts';

const rest = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0);
const groups = [
  { name: 'ear', vertices: [1, 2] },
  { name: 'selection only', vertices: [4] },
];

describe('handles by groups', () => {
  it('are held where they rest and moved where they do not', () => {
    const held = withHandles(noHandles, [0, 1, 2], rest);
    const pulled = movedHandles(held, [1, 2], translation([0, 0, 2]));
    expect(handleGroups(pulled, groups, rest)).toEqual([
      { name: 'ear', vertices: [1, 2], isMoved: true },
      { name: 'Held', vertices: [0], isMoved: false },
    ]);
    expect(pulled.targets).toEqual([
      [0, 0, 0],
      [1, 0, 2],
      [0, 1, 2],
    ]);
    expect(targetCenter(pulled, [1, 2])).toEqual([0.5, 0.5, 2]);
  });

  it('have those that are listed as fixed among the others, at rest', () => {
    const listed = { vertices: [1], targets: [[1, 0, 2]], fixed: [0, 4] } as const;
    expect(spelledOut(listed, rest)).toEqual({
      vertices: [1, 0, 4],
      targets: [
        [1, 0, 2],
        [0, 0, 0],
        [0, 3, 0],
      ],
    });
    const without = withHandles(noHandles, [1], rest);
    expect(spelledOut(without, rest)).toBe(without);
  });

  it('keep what a group of theirs has lost', () => {
    const handles = withHandles(noHandles, [0, 1, 2], rest);
    const left = withoutHandles(handles, [1]);
    expect(left.vertices).toEqual([0, 2]);
    expect(handleGroups(left, groups, rest)[0]).toEqual({ name: 'ear', vertices: [2], isMoved: false });
    expect(withoutHandles(left, [3])).toEqual(left);
  });

  it('put on twice are there once, at the last place', () => {
    const once = withHandles(noHandles, [1], rest);
    const moved = withHandles(
      once,
      [1, 3],
      Float64Array.from(rest, (x) => x + 1),
    );
    expect(moved).toEqual({
      vertices: [1, 3],
      targets: [
        [2, 1, 1],
        [1, 1, 2],
      ],
    });
  });

  it('look out of the surface that they are a patch of', () => {
    const triangles = Uint32Array.of(0, 1, 2, 1, 3, 2);
    expect(outlook(rest, triangles, [0, 1, 2])).toEqual([0, 0, 1]);
    expect(outlook(rest, triangles, [0, 1])).toEqual([0, 0, 0]);
  });

  it('stand on their lowest, or hang from their highest where the lowest is pulled', () => {
    const all = [0, 1, 2, 3, 4];
    expect(footing(rest, all, [4], 1)).toEqual([0, 1, 3]);
    expect(footing(rest, all, [0], 1)).toEqual([4]);
  });

  it('are pulled against their outermost where all lies flat', () => {
    const { positions } = plate(5);
    const all = [...Array(25).keys()];
    expect(footing(positions, all, [12], 2)).toEqual([0, 4, 20, 24]);
  });
});

const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
const point = fc.tuple(coordinate, coordinate, coordinate);
const direction = point.filter((p) => Math.hypot(...p) > 0.1).map(unit);

describe('movements of space', () => {
  const close = (a: Vec3, b: Vec3) => expect(distance(a, b)).toBeLessThan(1e-9);

  it('turn about their pivot and keep lengths', () => {
    fc.assert(
      fc.property(point, direction, coordinate, point, point, (pivot, axis, angle, a, b) => {
        const turn = rotationAbout(pivot, axis, angle);
        close(applied(turn, pivot), pivot);
        expect(distance(applied(turn, a), applied(turn, b))).toBeCloseTo(distance(a, b), 9);
      }),
    );
    close(applied(rotationAbout([1, 0, 0], [0, 0, 1], Math.PI / 2), [2, 0, 5]), [1, 1, 5]);
  });

  it('stretch along an axis only', () => {
    close(applied(scalingFrom([1, 1, 1], 3, [0, 1, 0]), [2, 2, 2]), [2, 4, 2]);
    close(applied(scalingFrom([1, 1, 1], 3, null), [2, 2, 2]), [4, 4, 4]);
  });

  it('are in a mirror what their images are', () => {
    const image = (p: Vec3, at: number): Vec3 => [2 * at - p[0], p[1], p[2]];
    fc.assert(
      fc.property(point, direction, coordinate, point, coordinate, (pivot, axis, angle, p, at) => {
        const by: Affine = rotationAbout(pivot, axis, angle);
        close(applied(mirrored(by, 0, at), image(p, at)), image(applied(by, p), at));
      }),
    );
    close(subtract(applied(mirrored(translation([1, 2, 3]), 0, 7), [0, 0, 0]), [-1, 2, 3]), [0, 0, 0]);
  });
});
