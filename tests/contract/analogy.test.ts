import { describe, expect, test } from 'vitest';
import { isFaceted } from '../../src/inputs/styles/faceted.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { resolveStyle, styleNames } from '../../src/inputs/styles/resolve.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import { encodedNumbers } from '../../src/methods/values/parameter.ts';
import { testCore } from '../fixtures/core.ts';
import { bunny, bunnyLevel, icosphere } from '../fixtures/meshes.ts';
import { run } from '../fixtures/runs.ts';
import { angleTo } from '../fixtures/surfaces.ts';

const resolved = (name: string, mapping: 'auto' | 'closest' | 'spherical' = 'auto') =>
  resolveStyle(name, mapping, async (mesh) => (await run(mesh, 'spherical', {})).positions);

describe('styles by name', () => {
  test.each(styleNames.filter((name) => !/prism|truncated|bipyramid/.test(name)))(
    '%s is read, and draws the bunny to it',
    async (name) => {
      const style = await resolved(name);
      expect(style.kind).toBe(findPrimitive(name) ? 'closest' : 'sphere');
      const mesh = bunny();
      const { positions, energy } = await run(mesh, 'analogy', { style, lambda: 2 });
      for (let k = 1; k < energy.length; k++)
        expect(energy[k]!).toBeLessThanOrEqual(energy[k - 1]! + 1e-8 * energy[0]!);
      expect(energy.at(-1)!).toBeLessThan(0.95 * energy[0]!);
      if (style.kind !== 'closest') return;
      const before = angleTo(style.normals, mesh);
      const after = angleTo(style.normals, { ...mesh, positions });
      expect(after).toBeLessThan(0.85 * before);
    },
  );

  test('facets keep one normal each, what is smooth is interpolated', async () => {
    const per = async (name: string) => ((await resolved(name)) as GaussMap & { per: string }).per;
    expect(await per('jessen')).toBe('face');
    expect(await per('oloid')).toBe('vertex');
    expect(await per('capsule')).toBe('vertex');
    expect(isFaceted(findPrimitive('dodecahedron')!.mesh)).toBe(true);
    expect(isFaceted({ ...icosphere(4) })).toBe(false);
  });

  test('a sphere in the style of a ball stays a ball; of a cube by either mapping it becomes one', async () => {
    const ball = icosphere(4);
    const style = await resolveStyle(ball, 'spherical', async (mesh) => mesh.positions);
    const { positions } = await run(ball, 'analogy', { style, lambda: 1 });
    const radii = Array.from({ length: positions.length / 3 }, (_, v) =>
      Math.hypot(...(positions.slice(3 * v, 3 * v + 3) as unknown as [number, number, number])),
    );
    expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(0.01);
    const cube = findPrimitive('cube')!.normals;
    for (const mapping of ['closest', 'spherical'] as const) {
      const asCube = await resolved('cube', mapping);
      const cubed = await run(ball, 'analogy', { style: asCube, lambda: 4, regularizer: 'farap' });
      expect(angleTo(cube, { ...ball, positions: cubed.positions })).toBeLessThan(6);
    }
  });

  test('what is no style is refused with a sentence', async () => {
    await expect(resolved('cubee')).rejects.toThrow(/There is no style “cubee”. Did you mean “cube”/);
    await expect(resolved('jessen', 'closest')).rejects.toThrow(/not convex/);
  });
});

describe('λ by vertex', () => {
  test('all the same is the one λ, to the bit; zero leaves the mesh alone', async () => {
    const mesh = bunny();
    const style = await resolved('octahedron');
    const each = (value: number) => new Float64Array(mesh.positions.length / 3).fill(value);
    for (const [method, more] of [
      ['analogy', { style }],
      ['cubic', {}],
    ] as const) {
      const limit = { ...more, maxIterations: 20 };
      const plain = await run(mesh, method, { ...limit, lambda: 0.5 });
      const same = await run(mesh, method, { ...limit, lambdaPerVertex: each(0.5) });
      expect(same.positions).toEqual(plain.positions);
      const none = await run(mesh, method, { ...limit, lambda: 0.5, lambdaPerVertex: each(0) });
      none.positions.forEach((x, i) => {
        expect(Math.abs(x - mesh.positions[i]!)).toBeLessThan(1e-9);
      });
    }
  });

  test('a wrong number of them, or one out of range, is refused', async () => {
    const session = (await testCore()).open();
    session.load(icosphere(1).positions, icosphere(1).triangles);
    expect(() => session.configure('cubic', new Map([['lambdaPerVertex', encodedNumbers([1, 2])]]))).toThrow(
      /2 numbers for 42 vertices/,
    );
    expect(() => session.configure('analogy', new Map()) as unknown).not.toThrow();
    expect(() => session.prepare()).toThrow(/needs a style/);
    session.free();
  });
});

describe('on the bunny at 22046 vertices', () => {
  test('all regularizers end lower and finite', { timeout: 60_000 }, async () => {
    const mesh = bunnyLevel(2);
    const style = await resolved('icosahedron');
    for (const regularizer of ['arap', 'farap', 'acap']) {
      const { positions, energy } = await run(mesh, 'analogy', {
        style,
        regularizer,
        maxIterations: 60,
      });
      expect(positions.every(Number.isFinite)).toBe(true);
      expect(energy.at(-1)!).toBeLessThan(energy[0]!);
    }
  });
});
