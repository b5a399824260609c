import { existsSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { activeStep, type Project } from '../../src/editor/project.ts';
import { recipeOf } from '../../src/editor/saved-recipe.ts';
import { newStep } from '../../src/editor/steps.ts';
import { remarks } from '../../src/mesh/report-sentences.ts';
import { methods } from '../../src/methods/registry.ts';
import { startingLambda } from '../../src/methods/starting-lambda.ts';
import type { NumberParameter } from '../../src/methods/values/number.ts';
import { parseRecipe } from '../../src/recipe/index.ts';
import { chooseMesh } from '../../web/app/choose-mesh.ts';
import { command, exportName, ownFormat } from '../../web/app/export.ts';
import { editableParameters, methodsByIntent, offeredMethods } from '../../web/app/offered-methods.ts';
import { fromTravel, toTravel, travel } from '../../web/panels/slider-scale.ts';
import { curve } from '../../web/panels/sparkline.ts';
import { plainReport } from '../fixtures/fake-engine.ts';

const lambda = methods[0]!.parameters.find(({ name }) => name === 'lambda') as NumberParameter;
const step = newStep({ method: 'cubic', parameters: { lambda: 0.35, tolerance: 3e-3, maxIterations: 50 } });
const project = {
  source: { name: "Ann's rabbit.glb", format: 'glb' },
  steps: [step],
  groups: [],
  active: step.id,
} as unknown as Project;
const stack = { ...project, steps: [step, newStep({ method: 'developable', parameters: {} })] };

describe('what is offered', () => {
  it('comes by what a person wants, without methods that only others need', () => {
    expect(methodsByIntent().map(({ title, methods }) => [title, ...methods.map(({ id }) => id)])).toEqual([
      ['Carve', 'cubic', 'analogy', 'polycube', 'normalmap'],
      ['Fold', 'developable'],
      ['Move', 'reshape', 'arap'],
    ]);
  });

  it('is told in words of its own wherever there is a control, and by a picture', () => {
    for (const method of offeredMethods()) {
      for (const parameter of editableParameters(method, true)) {
        expect(parameter.hint, `${method.id} ${parameter.name}`).not.toMatch(
          /[λα§]|Eq\.|normals? (are|is) drawn/,
        );
        expect(parameter.hint?.length, `${method.id} ${parameter.name}`).toBeGreaterThan(20);
        if (parameter.kind === 'choice' && parameter.labels)
          expect(Object.keys(parameter.labels)).toEqual(parameter.choices);
      }
      expect(existsSync(`public/thumbnails/methods/${method.id}.webp`), method.id).toBe(true);
    }
  });

  it('starts finer meshes with less', () => {
    const values = [100, 3000, 11_000, 100_000, 1_000_000].map(startingLambda);
    expect(values).toEqual([...values].sort((a, b) => b - a));
    expect(startingLambda(0)).toBeLessThanOrEqual(1.2);
  });
});

describe('the slider', () => {
  it('goes there and back for every stand', () => {
    for (let stand = 0; stand <= travel; stand++) {
      const value = fromTravel(lambda, stand);
      expect(Math.abs(toTravel(lambda, value) - stand)).toBeLessThanOrEqual(1);
    }
    expect(fromTravel(lambda, 0)).toBe(lambda.slider!.min);
    expect(fromTravel(lambda, travel)).toBe(lambda.slider!.max);
  });
});

describe('names and commands', () => {
  it('names the export after file and method', () => {
    expect(exportName(project, ownFormat(project).ending)).toBe("Ann's rabbit-cubic.glb");
    expect(exportName(stack, '.obj')).toBe("Ann's rabbit-whittled.obj");
  });

  it('writes a command that a shell reads', () => {
    expect(command(project).text).toBe(
      "npx whittle cubic 'Ann'\\''s rabbit.glb' --lambda 0.35 --max-iterations 50 --out 'Ann'\\''s rabbit-cubic.glb'",
    );
  });

  it('brings the recipe of several steps along', () => {
    const { text, needsProject } = command(stack);
    const [first, ...rest] = text.split('\n');
    expect(first).toBe(
      "npx whittle run - 'Ann'\\''s rabbit.glb' --out 'Ann'\\''s rabbit-whittled.glb' <<'RECIPE'",
    );
    expect(rest.splice(-2)).toEqual(['RECIPE', '']);
    expect(parseRecipe(rest.join('\n'), '')).toEqual(recipeOf(stack));
    expect(needsProject).toBe(false);
  });

  it('goes by the project where a file is named', () => {
    const named = { ...activeStep(project), method: 'analogy', parameters: { style: 'oloid.obj' } };
    expect(command({ ...project, steps: [named] })).toEqual({
      text: "npx whittle run 'Ann'\\''s rabbit.whittle.zip' --out 'Ann'\\''s rabbit-analogy.glb'",
      needsProject: true,
    });
  });
});

describe('dropped files', () => {
  const named = (...names: string[]) => names.map((name) => ({ name }));

  it.each([
    [['odd.bin'], 'odd.bin', null],
    [['a.mtl', 'wood.png', 'a.obj'], 'a.obj', /textures/],
    [['a.obj', 'b.stl'], 'a.obj', /one mesh/],
    [['a.mtl', 'wood.png'], undefined, /None/],
  ])('%j', (names, mesh, note) => {
    const choice = chooseMesh(named(...names));
    expect(choice.mesh?.name).toBe(mesh);
    if (note) expect(choice.note).toMatch(note);
    else expect(choice.note).toBeNull();
  });
});

describe('words about a mesh', () => {
  const plain = plainReport(4, 4);

  it('has none for a plain one and one for each oddity', () => {
    expect(remarks(plain, false)).toEqual([]);
    expect(remarks({ ...plain, components: 3, boundaryEdges: 12, nonManifoldEdges: 2 }, true)).toHaveLength(
      4,
    );
  });
});

describe('the energy curve', () => {
  it('falls from the top to the bottom of its box', () => {
    const points = curve([3, 2, 1])
      .split(' ')
      .map((point) => Number(point.split(',')[1]));
    expect(points[0]).toBeLessThan(points.at(-1)!);
    expect(curve([1])).toBe('');
  });
});
