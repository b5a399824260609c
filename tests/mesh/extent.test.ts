import { describe, expect, test } from 'vitest';
import { extentOf } from '../../src/mesh/extent.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';

const ball = icosphere(3);
const speck: TestMesh = {
  positions: Float64Array.of(0, 0, 0, 1e-3, 0, 0, 0, 1e-3, 0),
  triangles: Uint32Array.of(0, 1, 2),
};
const extent = ({ positions, triangles }: TestMesh) => extentOf(positions, triangles);
const beside = (mesh: TestMesh, other: TestMesh, ...offset: [number, number, number]): TestMesh =>
  together({ mesh, offset: [0, 0, 0] }, { mesh: other, offset });

describe('what matters of a mesh', () => {
  test.each([
    [3e4, 0, 0],
    [-2, -5e3, 1],
    [1e7, 1e7, 1e7],
  ] as const)('a speck at %f, %f, %f does not', (x, y, z) => {
    expect(extent(beside(ball, speck, x, y, z))).toEqual(extent(ball));
    expect(extent(beside(beside(ball, speck, x, y, z), speck, 0, 0, -1e5))).toEqual(extent(ball));
  });

  test('what no face uses does not, nor faces without a place', () => {
    const strays = Float64Array.of(...ball.positions, 1e9, 0, Number.NaN, Number.POSITIVE_INFINITY, 0, 0);
    const broken = Uint32Array.of(...ball.triangles, 0, 1, ball.positions.length / 3, 5, 6, 99999);
    expect(extentOf(strays, broken)).toEqual(extent(ball));
  });

  test('parts that a view can show do, and a fine mesh is no cloud of specks', () => {
    expect(extent(beside(ball, speck, 20, 0, 0)).max[0]).toBeCloseTo(20.001);
    expect(extent(beside(ball, ball, 150, 0, 0)).max[0]).toBeGreaterThan(150);
  });

  test('nothing has no extent', () => {
    expect(extentOf(new Float64Array(), new Uint32Array()).diagonal).toBe(0);
  });
});
