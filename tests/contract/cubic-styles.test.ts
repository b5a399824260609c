import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { Quaternion } from '../../src/methods/values/rotation.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { bunny, icosphere } from '../fixtures/meshes.ts';
import { angleTo } from '../fixtures/surfaces.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
});
afterAll(() => engine.dispose());

const mesh = { ...bunny(), hasUvs: false };
const carve = async (parameters: ParameterValues) =>
  (await engine.solve(mesh, { method: 'cubic', parameters, start: 'rest', positions: false })).positions;

/** About y. */
const eighth: Quaternion = [0, Math.sin(Math.PI / 8), 0, Math.cos(Math.PI / 8)];
const half = Math.SQRT1_2;
const bothWays = (...axes: number[]) => Float64Array.of(...axes, ...axes.map((part) => -part));
const upright = bothWays(1, 0, 0, 0, 1, 0, 0, 0, 1);
const turned = bothWays(half, 0, -half, 0, 1, 0, half, 0, half);

describe('cubic on the bunny', () => {
  test('normals go to the axes of the orientation, not to the file’s', async () => {
    const positions = await carve({ lambda: 0.4, orientation: eighth });
    expect(angleTo(turned, { ...mesh, positions })).toBeLessThan(0.75 * angleTo(turned, mesh));
    expect(angleTo(upright, { ...mesh, positions })).toBeGreaterThan(0.9 * angleTo(upright, mesh));
  });

  test('each region goes to its own axes', async () => {
    const heights = mesh.positions.filter((_, index) => index % 3 === 1);
    const middle = heights.slice().sort()[heights.length >> 1]!;
    const isUpper = (vertex: number) => heights[vertex]! > middle;
    const upper = [...heights.keys()].filter(isUpper);
    const after = await carve({ lambda: 0.4, frames: [{ vertices: upper, orientation: eighth }] });
    const facesWhere = (keep: boolean) =>
      mesh.triangles.filter((_, at, corners) =>
        corners.subarray(at - (at % 3), at - (at % 3) + 3).every((corner) => isUpper(corner) === keep),
      );
    const share = (axes: Float64Array, triangles: Uint32Array<ArrayBuffer>) =>
      angleTo(axes, { positions: after, triangles }) /
      angleTo(axes, { positions: mesh.positions, triangles });
    expect(share(turned, facesWhere(true))).toBeLessThan(0.8);
    expect(share(upright, facesWhere(false))).toBeLessThan(0.8);
    expect(share(turned, facesWhere(false))).toBeGreaterThan(0.9);
  });

  test('a matrix of one’s own is a polyhedron, and its lengths count', async () => {
    const rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const; // biome-ignore format: a matrix
    const plain = await carve({ lambda: 0.4, maxIterations: 30 });
    const scaled = rows.map(([x, y, z]) => [x / 2, y / 2, z / 2] as const);
    const same = await carve({ lambda: 0.8, polyhedron: scaled, maxIterations: 30 });
    const size = Math.max(...mesh.positions.map(Math.abs));
    for (const [index, value] of plain.entries())
      expect(Math.abs(same[index]! - value)).toBeLessThan(1e-3 * size);
    expect(await carve({ lambda: 0.4, maxIterations: 30 })).toEqual(plain);
  });
});

test('places that a file stores twice belong to the region that either is in, and to one only', async () => {
  const { positions, triangles } = icosphere(1);
  const twice = {
    positions: Float64Array.of(...positions, ...positions.slice(0, 3)),
    triangles: triangles.map((corner, at) => (corner === 0 && at % 2 === 0 ? positions.length / 3 : corner)),
    hasUvs: false,
  };
  const last = positions.length / 3;
  const solve = (frames: readonly { vertices: number[]; orientation: Quaternion }[]) =>
    engine.solve(twice, {
      ...({ method: 'cubic', start: 'rest', positions: false } as const),
      parameters: { lambda: 0.5, frames },
    });
  const first = await solve([{ vertices: [0], orientation: eighth }]);
  expect((await solve([{ vertices: [last], orientation: eighth }])).positions).toEqual(first.positions);
  expect((await solve([{ vertices: [0, last], orientation: eighth }])).positions).toEqual(first.positions);
  await expect(
    solve([
      { vertices: [0], orientation: eighth },
      { vertices: [last], orientation: [0, 0, 0, 1] },
    ]),
  ).rejects.toThrow(`Vertices 0 and ${last} are in regions 0 and 1 of “frames”, but they are the same point`);
  engine.release(twice);
});
