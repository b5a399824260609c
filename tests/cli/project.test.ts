import { mkdir } from 'node:fs/promises';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { sphereMap } from '../../src/inputs/styles/captures.ts';
import { captureFile } from '../../src/inputs/styles/exact-capture.ts';
import { packProject } from '../../src/io/index.ts';
import { unit } from '../../src/mesh/vectors.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './harness.ts';

const mesh = objText(icosphere(2));
const recipe = {
  whittle: 1,
  steps: [
    { method: 'cubic', lambda: 0.5, maxIterations: 5 },
    { method: 'analogy', style: 'styles/painted.png', maxIterations: 5 },
  ],
};
const ball = captureFile(sphereMap(([x, y, z]) => unit([x, y + 0.5, z])));
const encoded = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>;

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  const packed = await packProject({
    mesh: { name: 'in.obj', bytes: encoded(mesh) },
    beside: new Map(),
    recipe: JSON.stringify(recipe),
    assets: new Map([['styles/painted.png', ball]]),
  });
  await desk.write('a.whittle.zip', packed);
  await desk.write('in.obj', mesh);
});
afterEach(() => desk.clear());

test('a project runs as its unpacked folder does', async () => {
  expect(await desk.run('run @a.whittle.zip --out @zip.obj')).toEqual({ code: 0, stdout: '', stderr: '' });
  await mkdir(desk.path('styles'));
  await desk.write('styles/painted.png', ball);
  await desk.write('recipe.json', recipe);
  expect((await desk.run('run @recipe.json @in.obj --out @folder.obj')).code).toBe(0);
  expect(await desk.read('zip.obj')).toBe(await desk.read('folder.obj'));
  expect(await desk.read('zip.obj')).not.toBe(mesh);
});

test('the recipe of a project goes on another mesh', async () => {
  await desk.write('other.obj', objText(icosphere(1)));
  expect((await desk.run('run @a.whittle.zip @other.obj --out @out.obj')).code).toBe(0);
  expect((await desk.read('out.obj')).split('\n').filter((line) => line.startsWith('v '))).toHaveLength(42);
});

test('a recipe comes from stdin', async () => {
  const stdin = JSON.stringify({ whittle: 1, steps: [recipe.steps[0]] });
  expect((await desk.run('run - @in.obj --out @piped.obj', { stdin })).stderr).toBe('');
  expect((await desk.run('cubic @in.obj --lambda 0.5 --max-iterations 5 --out @typed.obj')).code).toBe(0);
  expect(await desk.read('piped.obj')).toBe(await desk.read('typed.obj'));
  const nothing = await desk.run('run - @in.obj --out @piped.obj');
  expect(nothing).toMatchObject({ code: 1, stderr: expect.stringContaining('stdin') });
});

test('what is missing in a project is said', async () => {
  const project = { mesh: { name: 'in.obj', bytes: encoded(mesh) }, beside: new Map(), assets: new Map() };
  await desk.write('b.zip', await packProject({ ...project, recipe: JSON.stringify(recipe) }));
  const missing = await desk.run('run @b.zip --out @out.obj');
  expect(missing).toMatchObject({
    code: 1,
    stderr: expect.stringContaining('painted.png: it is not in the project'),
  });
  await desk.write('c.zip', await packProject({ ...project, workspace: '{}' }));
  const off = await desk.run('run @c.zip --out @out.obj');
  expect(off).toMatchObject({ code: 1, stderr: expect.stringContaining('switched off') });
  await desk.write('d.zip', 'v 0 0 0');
  expect(await desk.run('run @d.zip --out @out.obj')).toMatchObject({ code: 1 });
});
