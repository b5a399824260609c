import { afterAll, beforeAll, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import { pngOfSphereField, readSphereField } from '../../src/inputs/fields/read-sphere-field.ts';
import { sampleSphere, sphereFieldOf } from '../../src/inputs/fields/sphere-field.ts';
import { decodePng } from '../../src/inputs/images/read.ts';
import { row, unit } from '../../src/mesh/vectors.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { Resolver, runRecipe } from '../../src/recipe/index.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { icosphere } from '../fixtures/meshes.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
});
afterAll(() => engine.dispose());

const ball = { ...icosphere(3), hasUvs: false };
const upward = sphereFieldOf(64, ([, y]) => Math.max(0, y));
const solve = async (parameters: ParameterValues) => {
  const all = { lambda: 0.5, maxIterations: 30, ...parameters };
  return (await engine.solve(ball, { method: 'cubic', parameters: all, start: 'rest', positions: false }))
    .positions;
};

test('of a field, the library and the core read the same: it is λ of each vertex by its normal', async () => {
  // The normals of a round ball are its places.
  const lambdaPerVertex = Float64Array.from(
    { length: ball.positions.length / 3 },
    (_, v) => 0.5 * sampleSphere(upward, unit(row(ball.positions, v))),
  );
  const [byNormal, byVertex, plain] = [
    await solve({ lambdaOnGaussMap: upward }),
    await solve({ lambdaPerVertex }),
    await solve({}),
  ];
  const apart = (a: Float64Array, b: Float64Array) =>
    Math.max(...a.map((value, k) => Math.abs(value - b[k]!)));
  expect(apart(byNormal, byVertex)).toBeLessThan(1e-3);
  expect(apart(byNormal, plain)).toBeGreaterThan(0.05);
  expect(await solve({ lambdaOnGaussMap: sphereFieldOf(4, () => 1) })).toEqual(plain);
});

test('a recipe names a picture: a file, or something that is at hand', async () => {
  const bytes = pngOfSphereField(upward);
  const reading = { readFile: async () => bytes, decodeImage: decodePng };
  const field = await readSphereField('up.png', reading);
  const step = (lambdaOnGaussMap: ParameterValues[string]) => ({
    steps: [{ method: 'cubic', parameters: { lambda: 0.5, maxIterations: 30, lambdaOnGaussMap } }],
  });
  const inline = await runRecipe(engine, { mesh: ball }, step(field));
  const named = await runRecipe(engine, { mesh: ball }, step('up.png'), { surroundings: reading });
  expect(named.mesh.positions).toEqual(inline.mesh.positions);
  const asset = { kind: 'sphere-field', field } as const;
  const surroundings = { asset: (name: string) => (name === 'mine.png' ? asset : undefined) };
  const painted = await runRecipe(engine, { mesh: ball }, step('mine.png'), { surroundings });
  expect(painted.mesh.positions).toEqual(inline.mesh.positions);
  const resolver = new Resolver(engine, {
    asset: () => ({ kind: 'mesh', mesh: ball }),
  });
  await expect(resolver.resolve(step('ball.obj').steps[0]!, { mesh: ball })).rejects.toThrow(/no field/);
  await expect(solve({ lambdaOnGaussMap: 'up.png' })).rejects.toThrow(/is the name “up\.png”/);
});

test('a recipe’s field that is none is refused', async () => {
  const values = new Float64Array(8);
  const refused = (field: object) => expect(solve({ lambdaOnGaussMap: field as never })).rejects;
  await refused({ width: 4, height: 3, values }).toThrow(/twice as wide/);
  await refused({ width: 4, height: 2, values: [0] }).toThrow(/must have 8 values/);
  await refused({ width: 4, height: 2, values: values.with(5, 1.5) }).toThrow(/value 5 is 1\.5/);
  await refused({ width: 4, height: 2, values, up: 'y' }).toThrow(/“up” too many/);
  await refused([1]).toThrow(/must name a PNG/);
});
