import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { fileServices } from '../../src/engine/file-services.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { ParameterValues, Quaternion } from '../../src/methods/descriptor.ts';
import { testCore } from '../fixtures/core.ts';
import { bunny, icosphere } from '../fixtures/meshes.ts';
import { angleTo } from '../fixtures/surfaces.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine({ spawn: () => spawnInProcess({ ...fileServices, loadCore: testCore }) });
});
afterAll(() => engine.dispose());

const mesh = { ...bunny(), hasUvs: false };
const carve = async (parameters: ParameterValues) =>
  (await engine.solve(mesh, { method: 'cubic', parameters, start: 'rest', frames: false })).positions;

/** About y. */
const eighth: Quaternion = [0, Math.sin(Math.PI / 8), 0, Math.cos(Math.PI / 8)];
const half = Math.SQRT1_2;
const turnedAxes = Float64Array.of(half, 0, -half, 0, 1, 0, half, 0, half);
const bothWays = (axes: Float64Array) => Float64Array.of(...axes, ...axes.map((part) => -part));

describe('cubic on the bunny', () => {
  test('normals go to the axes of the orientation, not to the file’s', async () => {
    const positions = await carve({ lambda: 0.4, orientation: eighth });
    const turned = bothWays(turnedAxes);
    const upright = bothWays(Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1));
    expect(angleTo(turned, { ...mesh, positions })).toBeLessThan(0.75 * angleTo(turned, mesh));
    expect(angleTo(upright, { ...mesh, positions })).toBeGreaterThan(0.9 * angleTo(upright, mesh));
  });

  test('each region goes to its own axes', async () => {
    const count = mesh.positions.length / 3;
    const heights = [...Array(count).keys()].map((vertex) => mesh.positions[3 * vertex + 1]!);
    const middle = [...heights].sort((a, b) => a - b)[count >> 1]!;
    const upper = [...Array(count).keys()].filter((vertex) => heights[vertex]! > middle);
    const positions = await carve({ lambda: 0.4, frames: [{ vertices: upper, orientation: eighth }] });
    const isUpper = (corner: number) => heights[corner]! > middle;
    const part = (keep: boolean) => {
      const faces = [...Array(mesh.triangles.length / 3).keys()].map((face) =>
        mesh.triangles.slice(3 * face, 3 * face + 3),
      );
      const triangles = Uint32Array.from(
        faces.filter((face) => face.every((corner) => isUpper(corner) === keep)).flatMap((face) => [...face]),
      );
      return { before: { positions: mesh.positions, triangles }, after: { positions, triangles } };
    };
    const turned = bothWays(turnedAxes);
    const upright = bothWays(Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1));
    const [top, bottom] = [part(true), part(false)];
    expect(angleTo(turned, top.after)).toBeLessThan(0.8 * angleTo(turned, top.before));
    expect(angleTo(upright, bottom.after)).toBeLessThan(0.8 * angleTo(upright, bottom.before));
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
      ...({ method: 'cubic', start: 'rest', frames: false } as const),
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
