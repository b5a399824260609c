import { describe, expect, test } from 'vitest';
import type { CoreSession } from '../../src/engine/core.ts';
import type { ParameterValues } from '../../src/methods/descriptor.ts';
import type { GaussMap } from '../../src/methods/gauss-map.ts';
import { isFaceted } from '../../src/styles/faceted.ts';
import { findPrimitive } from '../../src/styles/primitives.ts';
import { resolveStyle, styleNames } from '../../src/styles/resolve.ts';
import { testCore } from '../fixtures/core.ts';
import { bunny, bunnyLevel, icosphere, type TestMesh } from '../fixtures/meshes.ts';

/** One run of a method to its end. */
async function run(mesh: TestMesh, method: string, parameters: ParameterValues) {
  const session: CoreSession = (await testCore()).open();
  session.load(mesh.positions, mesh.triangles);
  session.configure(method, parameters);
  session.prepare();
  const energy: number[] = [];
  for (let outcome = 'running'; outcome === 'running'; ) {
    const step = session.step();
    energy.push(step.energy);
    outcome = step.outcome;
  }
  const positions = new Float64Array(mesh.positions.length);
  session.copyPositions(positions);
  session.free();
  return { positions, energy };
}

const resolved = (name: string, mapping: 'auto' | 'closest' | 'spherical' = 'auto') =>
  resolveStyle(name, mapping, async (mesh) => (await run(mesh, 'spherical', {})).positions);

/** Area-weighted mean angle of faces to the closest of some directions, degrees. */
function angleTo(normals: Float64Array, { positions, triangles }: TestMesh): number {
  let sum = 0;
  let area = 0;
  const at = (corner: number, axis: number): number => positions[3 * triangles[corner]! + axis]!;
  for (let face = 0; face < triangles.length; face += 3) {
    const a = [0, 1, 2].map((axis) => at(face + 1, axis) - at(face, axis)) as [number, number, number];
    const b = [0, 1, 2].map((axis) => at(face + 2, axis) - at(face, axis)) as [number, number, number];
    const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]] as const;
    const length = Math.hypot(...n);
    let best = -1;
    for (let i = 0; i < normals.length; i += 3) {
      const cosine = (n[0] * normals[i]! + n[1] * normals[i + 1]! + n[2] * normals[i + 2]!) / length;
      best = Math.max(best, cosine);
    }
    if (length > 0) sum += length * Math.acos(Math.min(1, best));
    area += length;
  }
  return ((sum / area) * 180) / Math.PI;
}

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
    expect(() => session.configure('cubic', { lambdaPerVertex: [1, 2] })).toThrow(
      /2 numbers for 42 vertices/,
    );
    expect(() => session.configure('analogy', {}) as unknown).not.toThrow();
    expect(() => session.prepare()).toThrow(/needs a style/);
    session.free();
  });
});

describe('on the bunny at 22046 vertices', () => {
  test('all regularizers end lower and finite', { timeout: 60_000 }, async () => {
    const mesh = bunnyLevel(2);
    const style = await resolved('icosahedron');
    for (const regularizer of ['arap', 'farap', 'acap']) {
      const { positions, energy } = await run(mesh, 'analogy', { style, regularizer, maxIterations: 60 });
      expect(positions.every(Number.isFinite)).toBe(true);
      expect(energy.at(-1)!).toBeLessThan(energy[0]!);
    }
  });
});
