import { writeFile } from 'node:fs/promises';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { pngOfSphereField } from '../../src/inputs/fields/read-sphere-field.ts';
import { sphereFieldOf } from '../../src/inputs/fields/sphere-field.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './harness.ts';

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  await desk.write('in.obj', objText(icosphere(2)));
});
afterEach(() => desk.clear());

/** The positions of a run that is to go well. */
async function carved(flags = '--quiet'): Promise<number[]> {
  const said = await desk.run(`cubic @in.obj --lambda 0.5 ${flags} --out @out.obj`);
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  return objPositions(await desk.read('out.obj'));
}

const farthest = (a: readonly number[], b: readonly number[]) =>
  a.reduce((most, value, index) => Math.max(most, Math.abs(value - b[index]!)), 0);

test('axes, orientation, frames and a matrix are typed or come from files', async () => {
  const plain = await carved();
  expect(await carved('--lambda-axes 1,1,1 --orientation 0,0,0,2')).toEqual(plain);
  expect(farthest(await carved('--lambda-axes 1,1,0.2'), plain)).toBeGreaterThan(0.05);
  const turned = await carved('--orientation 0,0,0.38,0.92');
  expect(farthest(turned, plain)).toBeGreaterThan(0.05);

  const all = plain.slice(0, plain.length / 3).map((_, vertex) => vertex);
  await desk.write('frames.json', [{ vertices: all, orientation: [0, 0, 0.38, 0.92] }]);
  expect(await carved('--frames @frames.json')).toEqual(turned);
  await desk.write('none.json', []);
  expect(await carved('--frames @none.json')).toEqual(plain);

  await desk.write('axes.json', [[1, 0, 0], [0, 1, 0], [0, 0, 1]]); // biome-ignore format: a matrix
  expect(farthest(await carved('--polyhedron @axes.json'), plain)).toBeLessThan(1e-4);
});

test('a recipe holds all of them', async () => {
  const steps = [
    {
      method: 'cubic',
      lambda: 0.5,
      polyhedron: [
        [1, 0, 0],
        [0.5, 0, 0.9],
        [0, 0.4, 0],
      ],
      orientation: [0, 0.38, 0, 0.92],
      frames: [{ vertices: [0, 1, 2], orientation: [0, 0, 0, 1] }],
    },
    { method: 'cubic', lambdaAxes: [0, 0, 1] },
  ];
  await desk.write('recipe.json', { whittle: 1, steps });
  const said = await desk.run('run @recipe.json @in.obj --out @out.obj');
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  expect(farthest(objPositions(await desk.read('out.obj')), await carved())).toBeGreaterThan(0.05);
});

const wrong: [string, number, RegExp][] = [
  ['--lambda-axes 1,1', 2, /^whittle: --lambda-axes: “lambdaAxes” must be 3 numbers .*not \[1,1\]/],
  ['--lambda-axes 1,x,1', 2, /not \[1,"x",1\]/],
  ['--orientation 0,0,0,0', 2, /--orientation: .*quaternion .*not all of them zero/],
  ['--polyhedron pyramid', 2, /--polyhedron: .*must be one of cube, .*12 rows/],
  ['--polyhedron @no.json', 1, /^no\.json: there is no such file/],
  ['--polyhedron @long.json', 1, /^in\.obj: Polyhedron must have rows from 0\.001 to 100 long; row 1 is not/],
  ['--polyhedron @zero.json', 1, /^zero\.json: “polyhedron” must list rows .*entry 0 is \[0,0,0\]/],
  ['--polyhedron hexagonal-prism --lambda-axes 1,1,0', 1, /^in\.obj: Only the cube has axes to weigh/],
  ['--frames @shape.json', 1, /^shape\.json: “frames” must be \[/],
  ['--frames @far.json', 1, /^in\.obj: “frames” names vertex 162 in region 0, .*\(0 to 161\)/],
  ['--frames @twice.json', 1, /^in\.obj: Vertex 1 is in regions 0 and 1 of “frames”; keep it in one/],
];

test.each(wrong)('whittle cubic %s ends with %i in one line', async (flags, code, message) => {
  const orientation = [0, 0, 0, 1];
  await desk.write('long.json', [[1, 0, 0], [0, 200, 0]]); // biome-ignore format: a matrix
  await desk.write('zero.json', [[0, 0, 0]]);
  await desk.write('shape.json', { vertices: [0] });
  await desk.write('far.json', [{ vertices: [162], orientation }]);
  await desk.write('twice.json', [
    { vertices: [0, 1], orientation },
    { vertices: [1], orientation },
  ]);
  const said = await desk.run(`cubic @in.obj ${flags} --out @out.obj`);
  expect(said).toMatchObject({ code, stdout: '', stderr: expect.stringMatching(message) });
  expect(said.stderr.trimEnd().split('\n')).toHaveLength(1);
  expect(await desk.list()).not.toContain('out.obj');
});

test('planes come from a file', async () => {
  await desk.write('planes.json', [{ vertices: [0, 5, 9], normal: [0, 0, 2], offset: 1 }]);
  const flat = await carved('--planes @planes.json');
  for (const vertex of [0, 5, 9]) expect(flat[3 * vertex + 2]).toBeCloseTo(0.5, 9);
});

test('strength by direction is a picture, or a field in a JSON file', async () => {
  const field = sphereFieldOf(32, ([x]) => (x < 0 ? 1 : 0));
  await writeFile(desk.path('left.png'), pngOfSphereField(field));
  await desk.write('left.json', { ...field, values: [...field.values] });
  const left = await carved('--lambda-on-gauss-map @left.png');
  expect(await carved('--lambda-on-gauss-map @left.json')).toEqual(left);
  expect(farthest(left, await carved())).toBeGreaterThan(0.02);
  await desk.write('recipe.json', {
    ...{ whittle: 1, steps: [{ method: 'cubic', lambda: 0.5, lambdaOnGaussMap: 'left.png' }] },
  });
  await desk.run('run @recipe.json @in.obj --quiet --out @out.obj');
  expect(objPositions(await desk.read('out.obj'))).toEqual(left);
});
