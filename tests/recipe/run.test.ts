import { afterAll, describe, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { type RecipeStep, Resolver, runRecipe, runStep } from '../../src/recipe/index.ts';
import { testCore, testFiles } from '../fixtures/core.ts';
import { icosphere } from '../fixtures/meshes.ts';

const engine: Engine = createEngine({ spawn: () => spawnInProcess({ ...testFiles, loadCore: testCore }) });
afterAll(() => engine.dispose());

const ball = icosphere(2) as Mesh;
const cubic: RecipeStep = { method: 'cubic', parameters: { lambda: 0.4 } };

describe('a recipe', () => {
  test('gives each step the shape that the one before left, and says what each did', async () => {
    const steps: RecipeStep[] = [cubic, { method: 'analogy', parameters: { style: 'octahedron' } }];
    const begun: string[] = [];
    const run = await runRecipe(
      engine,
      { mesh: ball },
      { steps },
      {
        onStep: ({ method }, index) => {
          begun.push(`${index} ${method}`);
          return undefined;
        },
      },
    );
    expect(begun).toEqual(['0 cubic', '1 analogy']);
    expect(run.steps.map(({ method, outcome }) => [method, outcome])).toEqual([
      ['cubic', 'converged'],
      ['analogy', 'converged'],
    ]);
    expect(run.input.vertices).toBe(162);
    const first = await runRecipe(engine, { mesh: ball }, { steps: [cubic] });
    expect(run.steps[0]!.positions).toEqual(first.mesh.positions);
    const second = await runRecipe(engine, { mesh: first.mesh }, { steps: steps.slice(1) });
    expect(run.mesh.positions).toEqual(second.mesh.positions);
  });

  test('keeps two vertices two that a step brought to one place', async () => {
    const [near, far] = [0, 7];
    const place = [0.2, 0.1, 0.3] as const;
    const together: RecipeStep = {
      method: 'arap',
      parameters: { handles: { vertices: [near, far], targets: [place, place] } },
    };
    const apart: RecipeStep = {
      method: 'arap',
      parameters: { handles: { vertices: [near, far], targets: [place, [2, 0, 0]] } },
    };
    const { mesh } = await runRecipe(engine, { mesh: ball }, { steps: [together, apart] });
    expect([...mesh.positions.subarray(3 * near, 3 * near + 3)]).toEqual(place);
    expect([...mesh.positions.subarray(3 * far, 3 * far + 3)]).toEqual([2, 0, 0]);
  });

  test('says which step was refused, and what names lead nowhere', async () => {
    const unnamed = { steps: [cubic, { method: 'analogy', parameters: { style: 'cubee' } }] };
    await expect(runRecipe(engine, { mesh: ball }, unnamed)).rejects.toThrow(
      /^“style”: There is no style “cubee”\. Did you mean “cube”/,
    );
    const noFile = { steps: [{ method: 'analogy', parameters: { style: 'own.obj' } }] };
    await expect(runRecipe(engine, { mesh: ball }, noFile)).rejects.toThrow(
      /^own\.obj: there is no such file/,
    );
    const handles = { vertices: [999], targets: [[0, 0, 0] as const] };
    const late = { steps: [cubic, { method: 'arap', parameters: { handles } }] };
    await expect(runRecipe(engine, { mesh: ball }, late, { name: 'ball.obj' })).rejects.toThrow(
      /^ball\.obj, step 2 \(arap\): “handles” names vertex 999/,
    );
  });

  test('takes assets before files and names of ours', async () => {
    const asset = { kind: 'gauss-map', map: { kind: 'closest', normals: Float64Array.of(0, 0, 1) } } as const;
    const step: RecipeStep = { method: 'analogy', parameters: { style: 'mine.png' } };
    const surroundings = { asset: (name: string) => (name === 'mine.png' ? asset : undefined) };
    const mine = await runRecipe(engine, { mesh: ball }, { steps: [step] }, { surroundings });
    const listed: RecipeStep = { method: 'analogy', parameters: { style: [[0, 0, 1]] } };
    const same = await runRecipe(engine, { mesh: ball }, { steps: [listed] });
    expect(mine.mesh.positions).toEqual(same.mesh.positions);
  });

  test('brings the fields that a method tells, where they are asked for', async () => {
    const step: RecipeStep = { method: 'analogy', parameters: { style: 'cube', regularizer: 'acap' } };
    const resolver = new Resolver(engine);
    expect((await runStep(engine, resolver, { mesh: ball }, step)).fields).toEqual([]);
    const { fields } = await runStep(engine, resolver, { mesh: ball }, step, { fields: true });
    expect(fields.map(({ name, unit }) => [name, unit])).toEqual([['size', '×']]);
    const { values } = fields[0]!;
    expect(values).toHaveLength(162);
    // A ball that becomes a cube shrinks on its sides and grows at its corners.
    expect(Math.min(...values)).toBeLessThan(0.99);
    expect(Math.max(...values)).toBeGreaterThan(Math.min(...values) + 0.01);
  });

  test('ends with the step that was cancelled, and keeps what that has', async () => {
    const stop = new AbortController();
    const run = await runRecipe(
      engine,
      { mesh: ball },
      { steps: [cubic, cubic, cubic] },
      {
        signal: stop.signal,
        onStep: (_, index) => {
          if (index === 1) stop.abort();
          return undefined;
        },
      },
    );
    expect(run.steps.map(({ outcome }) => outcome)).toEqual(['converged', 'cancelled']);
    expect(run.mesh.positions).toEqual(run.steps[0]!.positions);
    await expect(
      runRecipe(engine, { mesh: ball }, { steps: [cubic] }, { signal: stop.signal }),
    ).rejects.toThrow();
  });
});
