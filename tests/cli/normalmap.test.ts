import { writeFile } from 'node:fs/promises';
import { afterEach, beforeEach, expect, test } from 'vitest';
import type { Image } from '../../src/inputs/images/image.ts';
import { writePng } from '../../src/inputs/images/png.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { bakedGlb, normalMap, paint, plate, pngOf, texturedObj } from '../fixtures/textured.ts';
import { Desk } from './harness.ts';

const waves = (u: number, v: number): number => 0.02 * Math.sin(4 * Math.PI * u) * Math.sin(4 * Math.PI * v);

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  await desk.write('in.obj', texturedObj(plate(40)));
  await picture('map.png', normalMap(128, waves));
});
afterEach(() => desk.clear());

function picture(name: string, image: Image): Promise<void> {
  return writeFile(desk.path(name), pngOf(image));
}

async function raised(flags: string): Promise<number[]> {
  const said = await desk.run(`normalmap @in.obj ${flags} --out @out.obj`);
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  return objPositions(await desk.read('out.obj'));
}

/** How much of the waves there is in the plate’s heights. */
function gain(positions: readonly number[]): number {
  const input = plate(40).positions;
  let [shared, all] = [0, 0];
  for (let p = 0; p < positions.length; p += 3) {
    const wanted = waves(input[p]!, input[p + 1]!);
    shared += positions[p + 2]! * wanted;
    all += wanted * wanted;
  }
  return shared / all;
}

test('a normal map becomes shape, more so with strength, and inside out below 0', async () => {
  expect(gain(await raised('--image @map.png'))).toBeGreaterThan(0.85);
  expect(gain(await raised('--image @map.png --strength 0.5'))).toBeCloseTo(0.46, 1);
  expect(gain(await raised('--image @map.png --strength -1'))).toBeLessThan(-0.85);
  expect(gain(await raised('--image @map.png --green down'))).toBeLessThan(0.3);
});

test('without strength the file comes back as it was, byte for byte', async () => {
  await raised('--image @map.png --strength 0');
  expect(await desk.read('out.obj')).toBe(await desk.read('in.obj'));
  await picture(
    'flat.png',
    paint(16, () => [128 / 255, 127 / 255, 1]),
  );
  const said = await desk.run('normalmap @in.obj --image @flat.png --out @out.obj');
  expect(said).toMatchObject({
    code: 0,
    stderr: expect.stringContaining('The image is flat, so it raises nothing'),
  });
  expect(await desk.read('out.obj')).toBe(await desk.read('in.obj'));
});

test('brightness is height: white stands a twentieth of the picture’s width above black', async () => {
  await picture(
    'grey.png',
    paint(128, (u, v) => {
      const grey = 0.5 + waves(u, v) * 20;
      return [grey, grey, grey];
    }),
  );
  expect(gain(await raised('--image @grey.png'))).toBeGreaterThan(0.85);
  const said = await desk.run('normalmap @in.obj --image @grey.png --reading normals --out @no.obj');
  expect(said).toMatchObject({ code: 1, stderr: expect.stringContaining('no normal map') });
});

test('patterns go by name, and a recipe names its picture from its own folder', async () => {
  await raised('--image weave --regularizer farap --repeat 0.5');
  const step = { method: 'normalmap', image: 'map.png', strength: 0.7 };
  await desk.write('recipe.json', { whittle: 1, steps: [step] });
  expect((await desk.run('run @recipe.json @in.obj --out @run.obj')).stderr).toBe('');
  expect(objPositions(await desk.read('run.obj'))).toEqual(await raised('--image @map.png --strength 0.7'));
});

test('a normal map inside a glTF is unbaked unless another picture is named', async () => {
  await writeFile(desk.path('in.glb'), bakedGlb(plate(40), pngOf(normalMap(128, waves))));
  expect(await desk.run('normalmap @in.glb --out @baked.obj')).toEqual({ code: 0, stdout: '', stderr: '' });
  const [baked, named] = [objPositions(await desk.read('baked.obj')), await raised('--image @map.png')];
  // The GLB has a vertex for each corner, and single precision.
  const heights = (positions: readonly number[]) => [
    Math.min(...positions.filter((_, i) => i % 3 === 2)),
    Math.max(...positions.filter((_, i) => i % 3 === 2)),
  ];
  for (const k of [0, 1]) expect(heights(baked)[k]).toBeCloseTo(heights(named)[k]!, 5);
  await desk.run('normalmap @in.glb --image weave --out @woven.obj');
  expect(objPositions(await desk.read('woven.obj'))).not.toEqual(baked);
});

test('a mesh that is too coarse for the picture is told so', async () => {
  const said = await desk.run('normalmap @in.obj --image weave --repeat 20 --out @out.obj');
  expect(said.code).toBe(0);
  expect(said.stderr).toMatch(/in.obj: The image is finer than this mesh can show: an edge spans about \d+/);
});

test.each([
  ['in.obj', '', /normalmap.*needs an image/],
  ['in.obj', '--image waeve', /There is no pattern “waeve”. There is: weave, scales, hammered/],
  ['in.obj', '--image @none.png', /none.png: there is no such file/],
  ['in.obj', '--image @fake.png', /fake.png is not a PNG/],
  ['in.obj', '--image @cut.png', /cut.png could not be read as a PNG/],
  ['bare.obj', '--image weave', /bare.obj: The mesh has no texture coordinates, and normalmap needs them/],
  [
    'point.obj',
    '--image weave',
    /point.obj: The texture coordinates of all faces are single points or lines/,
  ],
])('%s %s is refused', async (mesh, flags, message) => {
  await desk.write('bare.obj', objText(icosphere(2)));
  await desk.write('point.obj', texturedObj({ ...plate(5), uvs: new Float32Array(6 * 32).fill(0.5) }));
  await desk.write('fake.png', 'no picture');
  const whole = writePng({ width: 8, height: 8, data: new Uint8Array(256) });
  await writeFile(desk.path('cut.png'), whole.subarray(0, 40));
  const said = await desk.run(`normalmap @${mesh} ${flags}${flags && ' '}--out @out.obj`);
  expect(said.code).toBe(1);
  expect(said.stderr).toMatch(message);
  expect(said.stderr.trim().split('\n')).toHaveLength(1);
  expect(await desk.list()).not.toContain('out.obj');
});
