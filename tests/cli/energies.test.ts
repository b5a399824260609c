import { afterEach, beforeEach, expect, test } from 'vitest';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './harness.ts';

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  await desk.write('in.obj', objText(icosphere(3)));
});
afterEach(() => desk.clear());

/** Runs it and gives the positions back. */
async function shaped(method: string, flags: string): Promise<number[]> {
  const said = await desk.run(`${method} @in.obj ${flags && `${flags} `}--max-iterations 8 --out @out.obj`);
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  return objPositions(await desk.read('out.obj'));
}

const axes = [
  [1, 0, 0],
  [-3, 0, 0],
  [0, 0.5, 0],
  [0, -1, 0],
  [0, 0, 1e200],
  [0, 0, -1],
];

test('directions are a name, by default the cube, a convex mesh or a list of any lengths', async () => {
  const cube = await shaped('polycube', '');
  expect(await shaped('polycube', '--directions cube')).toEqual(cube);
  await desk.write('axes.json', axes);
  expect(await shaped('polycube', '--directions @axes.json')).toEqual(cube);
  await desk.write('box.obj', objText(findPrimitive('cube')!.mesh));
  expect(await shaped('polycube', '--directions @box.obj')).toEqual(cube);
  expect(await shaped('polycube', '--directions octahedron --smoothing 0')).not.toEqual(cube);
});

test('a recipe holds the list itself, and runs methods one after the other', async () => {
  const steps = [
    { method: 'polycube', directions: axes, maxIterations: 8 },
    { method: 'developable', creases: 0.3, maxIterations: 8 },
  ];
  await desk.write('recipe.json', { whittle: 1, steps });
  expect((await desk.run('run @recipe.json @in.obj --out @run.obj')).stderr).toBe('');
  await shaped('polycube', '');
  await desk.write('in.obj', await desk.read('out.obj'));
  const after = await shaped('developable', '--creases 0.3');
  const run = objPositions(await desk.read('run.obj'));
  // The file in between has fewer digits.
  for (const [i, x] of run.entries()) expect(after[i]).toBeCloseTo(x, 2);
});

test.each([
  ['polycube --directions cubee', 1, /There is no style “cubee”. Did you mean “cube”/],
  ['polycube --directions jessen', 1, /not convex/],
  ['polycube --directions terraced', 1, /“terraced” is a normal capture and has no faces/],
  ['polycube --directions @zero.json', 1, /zero.json: .*list directions.*entry 1 is \[0,0,0\]/],
  ['polycube --directions @empty.json', 1, /empty.json: .*it is empty/],
  ['polycube --directions @none.json', 1, /none.json: there is no such file/],
  ['polycube --smoothing 2', 2, /must be a number from 0 to 1, not 2/],
  ['polycube --tolerance 1', 2, /--tolerance/],
  ['developable --creases 1.5', 2, /must be a number from 0 to 1, not 1.5/],
])('%s is refused', async (line, code, message) => {
  await desk.write('zero.json', [
    [1, 0, 0],
    [0, 0, 0],
  ]);
  await desk.write('empty.json', []);
  const [method, ...flags] = line.split(' ');
  const said = await desk.run(`${method} @in.obj ${flags.join(' ')} --out @out.obj`);
  expect(said.stderr).toMatch(message);
  expect(said.code).toBe(code);
  expect(await desk.list()).not.toContain('out.obj');
});
