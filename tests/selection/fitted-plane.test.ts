import { describe, expect, test } from 'vitest';
import { add, cross, dot, scale, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { fittedPlane, reachOf } from '../../src/selection/index.ts';

/** Places around a middle, on a plane but for a wave of some height. */
function sheet(normal: Vec3, middle: Vec3, height = 0): { places: number[]; which: number[] } {
  const n = unit(normal);
  const u = unit(cross(n, Math.abs(n[0]) < 0.5 ? [1, 0, 0] : [0, 1, 0]));
  const v = cross(n, u);
  const places: number[] = [9, 9, 9];
  for (let i = -4; i <= 4; i++)
    for (let j = -3; j <= 3; j++) {
      const wave = height * (i % 2 === 0 ? 1 : -1) * (j % 2 === 0 ? 1 : -1);
      places.push(...add(middle, add(add(scale(u, i), scale(v, j)), scale(n, wave))));
    }
  return { places, which: Array.from({ length: places.length / 3 - 1 }, (_, k) => k + 1) };
}

describe('the plane that places lie nearest to', () => {
  test.each([
    [
      [1, 2, 2],
      [3, -1, 4],
    ],
    [
      [-1, 0.4, 0.7],
      [0, 0, 0],
    ],
    [
      [0.3, -0.5, 0.8],
      [1e3, 2e3, -5e2],
    ],
  ] as const)('is that with normal %j through %j', (normal, middle) => {
    const { places, which } = sheet(normal, middle, 0.05);
    const plane = fittedPlane(places, which);
    expect(Math.abs(dot(plane.normal, unit(normal)))).toBeCloseTo(1, 3);
    expect(Math.max(...plane.normal)).toBe(Math.max(...plane.normal.map(Math.abs)));
    expect(dot(plane.normal, plane.center)).toBeCloseTo(plane.offset, 9);
    for (let k = 0; k < 3; k++) expect(plane.center[k]).toBeCloseTo(middle[k]!, 1);
    expect(reachOf(places, which, plane.center)).toBeCloseTo(5, 1);
  });

  test('lies across an axis where it nearly does, and only there', () => {
    const tilted = (degrees: number): Vec3 => [
      0,
      Math.cos((degrees * Math.PI) / 180),
      Math.sin((degrees * Math.PI) / 180),
    ];
    const normalAt = (degrees: number) => {
      const { places, which } = sheet(tilted(degrees), [0, 5, 0]);
      return fittedPlane(places, which).normal;
    };
    expect(normalAt(14)).toEqual([0, 1, 0]);
    expect(normalAt(-14)).toEqual([0, 1, 0]);
    expect(normalAt(20)[2]).toBeCloseTo(Math.sin((20 * Math.PI) / 180), 6);
  });

  test('goes through places that do not tell how it lies', () => {
    expect(fittedPlane([1, 2, 3], [0])).toEqual({ normal: [0, 0, 1], offset: 3, center: [1, 2, 3] });
    // On a line along z: a plane that holds them all.
    const line = fittedPlane([1, 2, 0, 1, 2, 5], [0, 1]);
    expect(line.normal).toEqual([0, 1, 0]);
    expect(line.offset).toBe(2);
  });
});
