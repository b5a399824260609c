import { expect, test } from 'vitest';
import { placedPlane, withoutPlane, withPlane } from '../../src/editor/planes.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';

/** Two triangles that share a side, whose ends the file stores twice: 0 and 3, 1 and 4 are one place each. */
const mesh: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0),
  triangles: Uint32Array.of(0, 1, 2, 4, 3, 5),
};
const floor = { vertices: [0, 1, 2], normal: [0, 0, 1] as const, offset: 0 };
const wall = { vertices: [3, 5], normal: [2, 0, 0] as const, offset: 0 };

test('vertices leave a parallel plane for another, wherever the file stores them, and are on crossing ones at once', () => {
  const planes = withPlane(withPlane([], mesh, floor), mesh, wall);
  expect(planes).toEqual([floor, wall]);
  const higher = { vertices: [3], normal: [0, 0, -3] as const, offset: -1 };
  expect(withPlane(planes, mesh, higher)).toEqual([{ ...floor, vertices: [1, 2] }, wall, higher]);
});

test('a plane without vertices is none', () => {
  expect(withPlane([floor], mesh, { ...wall, vertices: [] })).toEqual([floor]);
  const same = { ...floor, offset: 2 };
  expect(withPlane([floor], mesh, same)).toEqual([same]);
});

test('planes are placed and removed by their place in the list', () => {
  expect(placedPlane([floor, wall], 1, { offset: 4 })).toEqual([floor, { ...wall, offset: 4 }]);
  expect(placedPlane([floor], 0, { normal: [1, 0, 0], offset: 1 })).toEqual([
    { ...floor, normal: [1, 0, 0], offset: 1 },
  ]);
  expect(withoutPlane([floor, wall], 0)).toEqual([wall]);
});
