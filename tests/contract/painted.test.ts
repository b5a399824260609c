import { afterAll, beforeAll, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { type FieldBrush, FieldStroke, SphereCanvas, SurfaceCanvas } from '../../src/painting/index.ts';
import { alone, atOnce, mirrorMap, selectableOf } from '../../src/selection/index.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { icosphere } from '../fixtures/meshes.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
});
afterAll(() => engine.dispose());

const ball = { ...icosphere(3), hasUvs: false };
const surface = atOnce(selectableOf(ball));
const mirror = atOnce(mirrorMap(surface.places, 0));
const brush: FieldBrush = { operation: 'subtract', strength: 0.8, value: 0, radius: 0.5, hardness: 0.3 };

const solve = async (parameters: ParameterValues) => {
  const all = { lambda: 0.6, tolerance: 1e-4, ...parameters };
  return (await engine.solve(ball, { method: 'cubic', parameters: all, start: 'rest', positions: false }))
    .positions;
};

/** How far a shape is from its own mirror image. */
function asymmetry(positions: Float64Array): number {
  let most = 0;
  mirror.partner.forEach((other, v) => {
    if (other === alone) throw new Error('The mesh is not symmetric.');
    const [x, y, z] = [0, 1, 2].map((k) => positions[3 * other + k]!) as [number, number, number];
    const away = Math.hypot(positions[3 * v]! + x, positions[3 * v + 1]! - y, positions[3 * v + 2]! - z);
    most = Math.max(most, away);
  });
  return most;
}

test('a mirrored stroke on a symmetric mesh gives a symmetric shape, one that is not mirrored does not', async () => {
  const face = [...Array(surface.topology.triangles.length / 3).keys()].find((f) => {
    const v = surface.topology.triangles[3 * f]!;
    return surface.places[3 * v]! > 0.6 && surface.places[3 * v + 1]! > 0.3;
  })!;
  const painted = async (canvas: SurfaceCanvas) => {
    const stroke = new FieldStroke(canvas, new Float64Array(canvas.count).fill(1), brush);
    stroke.touch({ face, weights: [1, 0, 0] });
    return solve({ lambdaPerVertex: stroke.values.map((share) => 0.6 * share) });
  };
  const moved = Math.max(...(await solve({})).map((value, k) => Math.abs(value - ball.positions[k]!)));
  expect(asymmetry(await painted(new SurfaceCanvas(surface, mirror)))).toBeLessThan(2e-3 * moved);
  expect(asymmetry(await painted(new SurfaceCanvas(surface)))).toBeGreaterThan(0.05 * moved);
});

test('an even coat is the plain solve: on the mesh, and by direction', async () => {
  const half = await solve({ lambda: 0.3 });
  const everywhere = { ...brush, operation: 'set', strength: 1, value: 0.5, radius: 10 } as const;
  const onMesh = new SurfaceCanvas(surface);
  const coat = new FieldStroke(onMesh, new Float64Array(onMesh.count).fill(1), {
    ...everywhere,
    hardness: 1,
  });
  coat.touch({ face: 0, weights: [1, 0, 0] });
  expect(await solve({ lambdaPerVertex: coat.values.map((share) => 0.6 * share) })).toEqual(half);
  const sphere = new SphereCanvas(16);
  const sky = new FieldStroke(sphere, new Float64Array(sphere.count).fill(1), { ...everywhere, hardness: 1 });
  sky.touch([0, 0, 1]);
  expect(await solve({ lambdaOnGaussMap: { width: 32, height: 16, values: sky.values } })).toEqual(half);
});
