import { afterEach, beforeEach, expect, test } from 'vitest';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './harness.ts';

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  await desk.write('in.obj', objText(icosphere(2)));
});
afterEach(() => desk.clear());

/** Runs it and gives the positions back. */
async function styled(flags: string): Promise<number[]> {
  const said = await desk.run(`analogy @in.obj${flags && ` ${flags}`} --max-iterations 10 --out @out.obj`);
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  return objPositions(await desk.read('out.obj'));
}

test('a style is a name, by default the cube, or the file of a mesh', async () => {
  const cube = await styled('');
  expect(await styled('--style cube --lambda 1 --mapping closest')).toEqual(cube);
  await desk.write('box.obj', objText(findPrimitive('cube')!.mesh));
  expect(await styled('--style @box.obj')).toEqual(cube);
  expect(await styled('--style @box.obj --mapping spherical')).toHaveLength(cube.length);
  expect(await styled('--style octahedron')).not.toEqual(cube);
});

test('flags stand alone or say what they are', async () => {
  const still = await styled('--style octahedron');
  expect(await styled('--style octahedron --dynamic-targets=false')).toEqual(still);
  const dynamic = await styled('--style octahedron --dynamic-targets');
  expect(dynamic).not.toEqual(still);
  expect(await styled('--style octahedron --dynamic-targets=true')).toEqual(dynamic);
  const said = await desk.run('analogy @in.obj --dynamic-targets=perhaps --out @out.obj');
  expect(said).toMatchObject({ code: 2, stderr: expect.stringContaining('must be true or false') });
});

test('lambda by vertex comes from a file', async () => {
  await desk.write('half.json', [...Array(81).fill(0), ...Array(81).fill(2)]);
  const half = await styled('--lambda-per-vertex @half.json');
  expect(half).not.toEqual(await styled('--lambda 2'));
  await desk.write('short.json', [1, 2]);
  const short = await desk.run('analogy @in.obj --lambda-per-vertex @short.json --out @out2.obj');
  expect(short).toMatchObject({
    code: 1,
    stderr: expect.stringContaining('2 numbers, but the file has 162'),
  });
  await desk.write('odd.json', [1, -2]);
  const odd = await desk.run('analogy @in.obj --lambda-per-vertex @odd.json --out @out2.obj');
  expect(odd).toMatchObject({ code: 1, stderr: expect.stringContaining('entry 1 is -2') });
});

test('a recipe names its style’s file from its own folder', async () => {
  await desk.write('box.obj', objText(findPrimitive('octahedron')!.mesh));
  const step = { method: 'analogy', style: 'box.obj', maxIterations: 10, dynamicTargets: true };
  await desk.write('recipe.json', { whittle: 1, steps: [step] });
  expect((await desk.run('run @recipe.json @in.obj --out @run.obj')).stderr).toBe('');
  expect(objPositions(await desk.read('run.obj'))).toEqual(
    await styled('--style octahedron --dynamic-targets'),
  );
});

test.each([
  ['--style cubee', /There is no style “cubee”. Did you mean “cube”/],
  ['--style @none.obj', /none.obj: there is no such file/],
  ['--style @in.txt', /in.txt/],
  ['--style @photo.jpg', /photo.jpg: a normal capture is a PNG/],
  ['--style @photo.png', /photo.png: there is no such file/],
  ['--style @fake.png', /fake.png.*could not be read as a PNG/],
  ['--style jessen --mapping closest', /not convex/],
])('%s is refused', async (flags, message) => {
  await desk.write('in.txt', 'no mesh');
  await desk.write('fake.png', 'no picture');
  const said = await desk.run(`analogy @in.obj ${flags} --out @out.obj`);
  expect(said.code).toBe(1);
  expect(said.stderr).toMatch(message);
  expect(said.stderr.trim().split('\n')).toHaveLength(1);
  expect(await desk.list()).not.toContain('out.obj');
});
