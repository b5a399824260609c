import { afterAll, beforeAll, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { Plane } from '../../src/methods/values/planes.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { bunny, icosphere } from '../fixtures/meshes.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
});
afterAll(() => engine.dispose());

const along = (normal: readonly number[], positions: Float64Array, v: number) =>
  normal.reduce((sum, part, axis) => sum + part * positions[3 * v + axis]!, 0);

/** The vertices that lie lowest along a direction, on a plane there. */
function lowest(mesh: Mesh, normal: Plane['normal'], share: number): Plane {
  const heights = Float64Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
    along(normal, mesh.positions, v),
  );
  const offset = heights.slice().sort()[Math.round(share * heights.length)]!;
  return { vertices: [...heights.keys()].filter((v) => heights[v]! < offset), normal, offset };
}

/** Solves, and holds every shape that is shown against the planes. */
async function held(mesh: Mesh, planes: readonly Plane[], others: ParameterValues = {}) {
  const extents = [0, 1, 2].map((axis) => {
    const along = mesh.positions.filter((_, index) => index % 3 === axis);
    return Math.max(...along) - Math.min(...along);
  });
  const near = 1e-9 * Math.hypot(...extents);
  let shown = 0;
  const check = (positions: Float64Array) => {
    shown++;
    for (const { vertices, normal, offset } of planes)
      for (const v of vertices)
        expect(Math.abs(along(normal, positions, v) - offset) / Math.hypot(...normal)).toBeLessThan(near);
  };
  const parameters = { lambda: 0.4, planes, ...others };
  const settings = { method: 'cubic', parameters, start: 'rest', positions: true } as const;
  const solved = await engine.solve(mesh, settings, {
    onProgress: (progress) => {
      if (progress.kind === 'iterating' && progress.positions) check(progress.positions);
    },
  });
  check(solved.positions);
  expect(shown).toBeGreaterThan(1);
  return solved;
}

test('the bunny’s feet stay on any plane, at every shape that is shown', async () => {
  const mesh = { ...bunny(), hasUvs: false };
  for (const normal of [
    [0, 1, 0],
    [0.3, -2, 0.7],
  ] as const) {
    const { energy } = await held(mesh, [lowest(mesh, normal, 0.1)]);
    for (let k = 1; k < energy.length; k++)
      expect(energy[k]!).toBeLessThanOrEqual(energy[k - 1]! * (1 + 1e-7));
  }
});

test('no planes are the plain solve, and a seam is held by either of its places', async () => {
  const { positions, triangles } = icosphere(2);
  const last = positions.length / 3;
  const mesh = {
    positions: Float64Array.of(...positions, ...positions.slice(0, 3)),
    triangles: triangles.map((corner, at) => (corner === 0 && at % 2 === 0 ? last : corner)),
    hasUvs: false,
  };
  const plane = (vertices: number[]): Plane => ({ vertices, normal: [0, 0, 2], offset: 1.5 });
  const plain = await held(mesh, []);
  expect((await held(mesh, [plane([])])).positions).toEqual(plain.positions);
  const first = await held(mesh, [plane([0])]);
  expect((await held(mesh, [plane([last])])).positions).toEqual(first.positions);
  expect((await held(mesh, [plane([0, last])])).positions).toEqual(first.positions);
  const elsewhere = { ...plane([last]), offset: 3 };
  await expect(held(mesh, [plane([0]), elsewhere])).rejects.toMatchObject({
    ...{
      code: 'bad-planes',
      element: 0,
      message: expect.stringMatching(/^Vertex 0 is on planes that have no/),
    },
  });
  const handles = { vertices: [last], targets: [[0, 0, 2] as const] };
  await expect(held(mesh, [plane([0])], { handles })).rejects.toMatchObject({
    ...{
      code: 'bad-planes',
      element: 0,
      message: expect.stringMatching(/^Vertex 0 is on plane 0, but a handle/),
    },
  });
});
