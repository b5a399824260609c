import { afterAll, describe, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import { type RecipeStep, runRecipe } from '../../src/recipe/index.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { icosphere, type TestMesh } from '../fixtures/meshes.ts';

const engine: Engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
afterAll(() => engine.dispose());

/** An egg with a dent: nothing about it is special, and it is genus 0. */
const plain: TestMesh = (() => {
  const { positions, triangles } = icosphere(2);
  const x = positions.slice();
  for (let i = 0; i < x.length; i += 3) {
    const [a, b, c] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
    x.set([1.3 * a + 0.11 * b, 0.9 * b + 0.07 * c * a, 0.7 * c + 0.2 * a * a - 0.13 * b], i);
  }
  return { positions: x, triangles };
})();
const count = plain.positions.length / 3;
const reversed = (triangles: Uint32Array): number[] =>
  Array.from(triangles, (_, c) => triangles[c - (c % 3) + 2 - (c % 3)]!);
const jitter = (x: number, i: number): number => x + 1e-7 * Math.sin(12.9898 * i);

/** The same shape as people have it. The first vertices are those of the plain one. */
const kinds: Record<string, TestMesh> = {
  'two-sided': { ...plain, triangles: Uint32Array.of(...plain.triangles, ...reversed(plain.triangles)) },
  'two-sided in part': {
    ...plain,
    triangles: Uint32Array.of(...plain.triangles, ...reversed(plain.triangles.subarray(0, 150))),
  },
  'two-sided, the back with vertices of its own': {
    positions: Float64Array.of(...plain.positions, ...plain.positions),
    triangles: Uint32Array.of(...plain.triangles, ...reversed(plain.triangles).map((v) => v + count)),
  },
  'three times': {
    ...plain,
    triangles: Uint32Array.of(...plain.triangles, ...plain.triangles, ...plain.triangles),
  },
  'partly turned': {
    ...plain,
    triangles: plain.triangles.map((v, c) =>
      Math.floor(c / 3) % 5 === 1 ? reversed(plain.triangles)[c]! : v,
    ),
  },
  'with strays': {
    positions: Float64Array.of(...plain.positions, 1e6, -1e5, 3, Number.NaN, 0, Number.POSITIVE_INFINITY),
    triangles: plain.triangles,
  },
  'a soup of triangles with noise, behind the vertices': {
    positions: Float64Array.of(
      ...plain.positions,
      ...Array.from(plain.triangles).flatMap((v, c) =>
        [0, 1, 2].map((axis) => jitter(plain.positions[3 * v + axis]!, 3 * c + axis)),
      ),
    ),
    triangles: Uint32Array.of(
      ...plain.triangles.subarray(0, 6),
      ...Array.from(plain.triangles.keys())
        .slice(6)
        .map((c) => count + c),
    ),
  },
};

const handles = {
  vertices: [plain.triangles[0]!, plain.triangles[5]!],
  targets: [[0, 0, 0.1] as const, [2, 1, 0] as const],
};
const steps: RecipeStep[] = [
  { method: 'cubic', parameters: { lambda: 0.4 } },
  { method: 'analogy', parameters: { style: 'cone', lambda: 2 } },
  { method: 'analogy', parameters: { style: 'octahedron', lambda: 2, regularizer: 'farap' } },
  { method: 'polycube', parameters: { maxIterations: 5 } },
  { method: 'developable', parameters: { maxIterations: 8 } },
  { method: 'arap', parameters: { handles } },
  { method: 'spherical', parameters: {} },
];

const shaped = async (mesh: TestMesh, step: RecipeStep): Promise<Float64Array> =>
  (await runRecipe(engine, { mesh }, { steps: [step] })).mesh.positions;

describe.each(steps)('$method $parameters.style', (step) => {
  test.each(Object.keys(kinds))('%s: as the plain mesh', async (kind) => {
    const mesh = kinds[kind]!;
    const expected = await shaped(plain, step);
    const positions = await shaped(mesh, step);
    const used = new Set(mesh.triangles);
    let worst = 0;
    for (let v = 0; v < count; v++)
      if (used.has(v))
        for (let i = 3 * v; i < 3 * v + 3; i++)
          worst = Math.max(worst, Math.abs(positions[i]! - expected[i]!));
    expect(worst).toBeLessThan(2e-3);
    // What no face uses is where it was, whatever that is.
    for (let p = count; p < mesh.positions.length / 3; p++)
      if (!used.has(p))
        expect(positions.subarray(3 * p, 3 * p + 3)).toEqual(mesh.positions.subarray(3 * p, 3 * p + 3));
  });
});

test('what was done about it is said, in the report and with the result', async () => {
  const report = await engine.inspect(kinds['two-sided in part']!);
  expect([report.faces, report.duplicateFaces, report.turnedFaces]).toEqual([370, 50, 0]);
  const { steps: done } = await runRecipe(
    engine,
    { mesh: kinds['partly turned']! },
    { steps: steps.slice(0, 1) },
  );
  expect(done[0]!.warnings).toEqual([expect.stringMatching(/^64 faces looked the other way/)]);
});
