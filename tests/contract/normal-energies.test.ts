import { describe, expect, test } from 'vitest';
import { createEngine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { resolveStyle } from '../../src/inputs/styles/resolve.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { bunny, bunnyLevel, type TestMesh } from '../fixtures/meshes.ts';
import { run } from '../fixtures/runs.ts';
import { angleDefects, angleTo, faces, shareWithin, volumeInside } from '../fixtures/surfaces.ts';

const directions = (name: string) =>
  resolveStyle(name, 'closest', () => Promise.reject(new Error('nothing flows here')));

/** How the Gaussian curvature lies: the share of vertices with next to none, and of the whole what the worst twentieth holds. */
function spread(mesh: TestMesh, small: number): { flat: number; top: number } {
  const sizes = angleDefects(mesh).map(Math.abs).sort();
  const sum = (some: Float64Array) => some.reduce((total, value) => total + value, 0);
  return {
    flat: sizes.filter((value) => value < small).length / sizes.length,
    top: sum(sizes.slice(Math.floor(0.95 * sizes.length))) / sum(sizes),
  };
}

describe('polycube', () => {
  test('the bunny becomes boxes: angles, area within 10°, volume (2021, §5.1)', async () => {
    const mesh = bunny();
    const { positions } = await run(mesh, 'polycube', { directions: await directions('cube') });
    const boxed = { ...mesh, positions };
    const axes = findPrimitive('cube')!.normals;
    expect(angleTo(axes, mesh)).toBeGreaterThan(25);
    expect(angleTo(axes, boxed)).toBeLessThan(1.8);
    expect(shareWithin(10, axes, boxed)).toBeGreaterThan(0.97);
    const share = volumeInside(boxed) / volumeInside(mesh);
    expect(share).toBeGreaterThan(0.6);
    expect(share).toBeLessThan(0.75);
  });

  test.each(['hexagonal-prism', 'octahedron', 'tetrahedron', 'dodecahedron'])(
    'the directions of the %s make other boxes (2021, Fig. 18)',
    async (name) => {
      const mesh = bunny();
      const { positions } = await run(mesh, 'polycube', { directions: await directions(name) });
      const { normals } = findPrimitive(name)!;
      expect(angleTo(normals, { ...mesh, positions })).toBeLessThan(0.2 * angleTo(normals, mesh));
      expect(shareWithin(10, normals, { ...mesh, positions })).toBeGreaterThan(0.9);
    },
  );

  test('an engine runs it from the file’s own shape, wherever the run before ended', async () => {
    const spawn = () => spawnInProcess({ ...testFiles, loadCore: testCore });
    const engine = createEngine({ spawn });
    const mesh = { ...bunny(), hasUvs: false };
    const parameters = { directions: await directions('cube'), maxIterations: 12 };
    const settings = { method: 'polycube', parameters, start: 'rest', positions: false } as const;
    const first = await engine.solve(mesh, settings);
    expect([first.outcome, first.iterations]).toEqual(['iteration-limit', 12]);
    const again = await engine.solve(mesh, { ...settings, start: 'current' });
    expect(again.positions).toEqual(first.positions);
    await expect(
      engine.solve(mesh, { ...settings, parameters: { directions: [[0, 0, 1]] } }),
    ).rejects.toThrow(/is a list of directions, but the engine takes a Gauss map itself/);
    const ball = {
      kind: 'sphere',
      points: mesh.positions,
      triangles: mesh.triangles,
      normals: mesh.positions,
      per: 'vertex',
    } as const;
    await expect(engine.solve(mesh, { ...settings, parameters: { directions: ball } })).rejects.toThrow(
      /“directions” must hold directions: those of a convex shape/,
    );
    engine.dispose();
  });
});

describe('developable', () => {
  test.each([
    ['1839', bunny],
    ['7350', () => bunnyLevel(1)],
  ])('curvature leaves most of the bunny of %s vertices and gathers on creases', async (_, make) => {
    const mesh = make();
    const before = angleDefects(mesh).map(Math.abs);
    const small = (0.2 * before.reduce((sum, value) => sum + value, 0)) / before.length;
    const was = spread(mesh, small);
    const { positions, energy } = await run(mesh, 'developable', {});
    expect(energy).toHaveLength(150);
    const is = spread({ ...mesh, positions }, small);
    expect(is.flat).toBeGreaterThan(was.flat + 0.15);
    expect(is.top).toBeGreaterThan(1.15 * was.top);
    const area = (surface: TestMesh) => faces(surface).reduce((sum, face) => sum + face.area, 0);
    expect(area({ ...mesh, positions }) / area(mesh)).toBeCloseTo(1, 2);
  });

  test('fewer creases leave less curvature', async () => {
    const mesh = bunny();
    const whole = async (creases: number) => {
      const { positions } = await run(mesh, 'developable', { creases });
      return angleDefects({ ...mesh, positions }).reduce((sum, value) => sum + Math.abs(value), 0);
    };
    const [few, some, many] = [await whole(0.1), await whole(0.5), await whole(1)];
    expect(few).toBeLessThan(some);
    expect(some).toBeLessThan(many);
  });
});
