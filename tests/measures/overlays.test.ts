import { describe, expect, it } from 'vitest';
import { measuredOf } from '../../src/editor/measured.ts';
import type { Assets, Project } from '../../src/editor/project.ts';
import { inputsOf } from '../../src/editor/project.ts';
import { newStep } from '../../src/editor/steps.ts';
import { measure as measureOf, measuresFor, type OverlayName } from '../../src/measures/index.ts';
import { histogram, rangeOf, type Scale, shareOf, ticksOf } from '../../src/measures/scale.ts';
import { mean, quantile, roundedUp } from '../../src/measures/statistics.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { blank, ramp, rampColors } from '../../web/app/color-ramp.ts';
import { followOverlay } from '../../web/app/overlay-paint.ts';
import { newPageStore } from '../../web/app/page-state.ts';
import { icosphere, type TestMesh } from '../fixtures/meshes.ts';
import { openCylinder, torus } from '../fixtures/shapes.ts';

/** What a step of the project says, and the values that the engine had for it. */
interface Said {
  readonly method?: string;
  readonly parameters?: ParameterValues;
  readonly resolved?: ParameterValues;
}

/** A project of a mesh with one step, shaped by a map of its places. */
function projectOf(
  { positions, triangles }: TestMesh,
  { method = 'cubic', parameters = {}, resolved = parameters }: Said = {},
  place?: (x: number, i: number, all: Float64Array) => number,
): Project {
  const mesh: Mesh = { positions, triangles };
  const step = newStep({ method, parameters });
  const assets: Assets = new Map();
  const result = place && {
    positions: positions.map(place) as Float64Array<ArrayBuffer>,
    state: 'settled' as const,
    outcome: 'converged' as const,
    iterations: 1,
    energy: [],
    milliseconds: 1,
    warnings: [],
    fields: [],
    of: inputsOf(step, positions, assets),
    resolved,
  };
  return {
    source: { bytes: Uint8Array.of(), name: 'a.obj', format: 'obj' },
    mesh,
    report: {} as never,
    steps: [{ ...step, result: result ?? null }],
    active: step.id,
    assets,
    groups: [],
  };
}

const measure = (project: Project, name: OverlayName, comparing = false) =>
  measureOf(measuredOf(project), name, comparing);

const names = (project: Project) => measuresFor(measuredOf(project)).map(({ name }) => name);
const rising: Scale = { kind: 'rising', end: 5, unit: '°' };
const signed: Scale = { kind: 'signed', end: 4, unit: '' };
const factor: Scale = { kind: 'factor', end: 2 };

describe('what is offered', () => {
  it('is what there is: after, movement and size of a result, angles of a style, strength of a list', () => {
    const ball = icosphere(1);
    expect(names(projectOf(ball))).toEqual(['angle-before', 'curvature-before']);
    expect(names(projectOf(ball, {}, (x) => x))).toEqual([
      ...['angle-before', 'angle-after', 'curvature-before', 'curvature-after', 'movement', 'growth', 'turn'],
    ]);
    expect(names(projectOf(ball, { method: 'arap' }))).toEqual(['curvature-before']);
    expect(names(projectOf(ball, { parameters: { polyhedron: 'rhombic-dodecahedron' } }))).toEqual([
      'curvature-before',
    ]);
    const each = new Float64Array(ball.positions.length / 3).fill(2);
    expect(names(projectOf(ball, { parameters: { lambdaPerVertex: each } }))).toContain('strength');
    expect(names(projectOf(ball, { parameters: { lambdaPerVertex: [1, 2] } }))).not.toContain('strength');
  });

  it('measures nothing else', () => {
    const project = projectOf(icosphere(1));
    for (const name of ['none', 'angle-after', 'movement', 'growth', 'strength'] as const)
      expect(measure(project, name)).toBeNull();
  });

  it('shows the file’s own while that is on the screen', () => {
    const project = projectOf(icosphere(1), {}, (x, i) => (i % 3 === 0 ? 2 * x : x));
    const name = (one: OverlayName, comparing: boolean) => measure(project, one, comparing)!.title;
    expect(name('curvature-after', false)).toContain('after');
    expect(name('curvature-after', true)).toContain('before');
    expect(name('angle-after', true)).toContain('before');
    expect(name('movement', true)).toBe(name('movement', false));
  });
});

describe('angles', () => {
  it('are told on one scale before and after', () => {
    const project = projectOf(icosphere(3), {}, (x, i) => (i % 3 === 0 ? 1.5 * x : x));
    const [before, after] = [measure(project, 'angle-before')!, measure(project, 'angle-after')!];
    expect(after.scale).toEqual(before.scale);
    // At most the angle between a corner of a cube and its sides.
    expect(Math.max(...before.values)).toBeLessThan(54.75);
    expect(Math.max(...before.values)).toBeGreaterThan(45);
    expect(before.summary).toMatch(/^on average \d\d\.\d°$/);
    expect(after.values).not.toEqual(before.values);
  });

  it('go to targets of the input, or of the output where those follow', () => {
    const map = { kind: 'closest', normals: Float64Array.of(1, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, -1) } as const;

    const plate = {
      positions: Float64Array.of(0, 0, 0, 0, 1, 0, -0.5, 0, 1),
      triangles: Uint32Array.of(0, 1, 2),
    };
    // Its normal is nearer to x; sheared, to z.
    const shear = (x: number, i: number) => (i === 6 ? 1.5 * -2 : x);
    const angle = (dynamicTargets: boolean) => {
      const project = projectOf(
        plate,
        { method: 'analogy', parameters: { dynamicTargets }, resolved: { style: map } },
        shear,
      );
      return measure(project, 'angle-after')!.values[0]!;
    };
    expect(angle(false)).toBeCloseTo((Math.atan(3) * 180) / Math.PI, 3);
    expect(angle(true)).toBeCloseTo((Math.atan(1 / 3) * 180) / Math.PI, 3);
  });
});

describe('curvature', () => {
  it('is told in that of a ball of the same surface, on both sides of 0', () => {
    const project = projectOf(torus(60, 30), {}, (x) => 7 * x);
    const [before, after] = [measure(project, 'curvature-before')!, measure(project, 'curvature-after')!];
    const perBall = (4 * Math.PI ** 2 * 0.4) / (4 * Math.PI);
    expect(Math.max(...before.values)).toBeCloseTo(perBall / (0.4 * 1.4), 0);
    expect(Math.min(...before.values)).toBeCloseTo(-perBall / (0.4 * 0.6), 0);
    // Seven times as large, a 49th of the curvature, in units of the file's own surface.
    after.values.forEach((value, p) => {
      expect(value).toBeCloseTo(before.values[p]! / 49, 4);
    });
    expect(ticksOf(before.scale)).toEqual(['−5', '0', '5 × a ball’s']);
    expect(after.scale).toEqual(before.scale);
  });

  it('knows what can be unrolled, and leaves the boundary blank', () => {
    const roll = projectOf(openCylinder(30, 10), {}, (x, i) => (i % 3 === 2 ? x : x * (1 + 0.4 * (i % 2))));
    const overlay = measure(roll, 'curvature-after')!;
    expect(overlay.verdict).toBe(
      'Nearly flat, under 0.2 × a ball’s: 100 % of the vertices before, 100 % after.',
    );
    expect(overlay.blank).toBe('boundary');
    expect(overlay.values.filter(Number.isNaN)).toHaveLength(60);
    expect(measure(projectOf(icosphere(2)), 'curvature-before')).toMatchObject({
      summary: '0 % nearly flat',
    });
    expect(measure(projectOf(icosphere(2)), 'curvature-before')).not.toHaveProperty('blank');
  });
});

describe('size', () => {
  it('is the factor that everything grew by', () => {
    const overlay = measure(
      projectOf(icosphere(2), {}, (x) => 1.4 * x),
      'growth',
    )!;
    for (const value of overlay.values) expect(value).toBeCloseTo(1.4, 5);
    expect(overlay).toMatchObject({
      summary: 'mostly ×1.4 to ×1.4',
      scale: { kind: 'factor', end: 1.5 },
    });
  });

  it('sees where it grew and where it shrank', () => {
    const flare = (x: number, i: number, all: Float64Array) =>
      i % 3 === 2 ? x : x * (0.6 + 0.4 * all[i - (i % 3) + 2]!);
    const pipe = openCylinder(40, 21);
    const overlay = measure(
      projectOf(pipe, {}, (x, i) => flare(x, i, pipe.positions)),
      'growth',
    )!;
    expect(overlay.values[0]!).toBeLessThan(0.85);
    expect(overlay.values.at(-1)!).toBeGreaterThan(1.1);
  });
});

describe('tilt', () => {
  it('is the angle by which each place looks elsewhere than in the file', () => {
    const { positions, triangles } = openCylinder(40, 21);
    const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
    // Turned about the z axis.
    const turned = (x: number, i: number) =>
      i % 3 === 0 ? c * x - s * positions[i + 1]! : i % 3 === 1 ? s * positions[i - 1]! + c * x : x;
    const overlay = measure(projectOf({ positions, triangles }, {}, turned), 'turn')!;
    for (const value of overlay.values) expect(value).toBeCloseTo((0.3 * 180) / Math.PI, 3);
    expect(overlay).toMatchObject({
      summary: 'on average 17.2°, 17.2° at most',
      scale: { kind: 'rising', end: 20, unit: '°' },
    });
    const still = measure(
      projectOf({ positions, triangles }, {}, (x) => 2 * x),
      'turn',
    )!;
    expect(Math.max(...still.values)).toBeLessThan(0.1);
  });

  it('shows a flat side that stays as it was, though an edge of it bends', () => {
    // A roof of two squares; the second is lifted.
    const positions = Float64Array.of(0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0);
    const triangles = Uint32Array.of(0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3);
    const lift = (x: number, i: number) => (i === 14 || i === 17 ? 1 : x);
    const { values } = measure(projectOf({ positions, triangles }, {}, lift), 'turn')!;
    expect([...values].map(Math.round)).toEqual([0, 0, 45, 45, 45, 45]);
  });
});

describe('strength by vertex', () => {
  it('is what the parameters hold, the mean where the file stores a place twice', () => {
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    const seamed = { positions, triangles: Uint32Array.of(0, 1, 2, 3, 4, 5) };
    const parameters = { lambdaPerVertex: [0, 1, 2, 3, 4, 0] };
    const overlay = measure(projectOf(seamed, { parameters }), 'strength')!;
    expect([...overlay.values]).toEqual([0, 2, 1, 2, 4, 1]);
    expect(overlay.scale).toEqual({ kind: 'rising', end: 4, unit: '' });
  });
});

describe('fields of a method', () => {
  const ball = icosphere(1);
  const count = ball.positions.length / 3;
  const plain = { mesh: ball as Mesh, positions: null, targets: null, strengths: null };
  const field = { name: 'size', label: 'Change of size', unit: '×' } as const;

  it('are offered by their labels and shown on a scale that suits their unit', () => {
    const values = Float64Array.from({ length: count }, (_, v) => (v % 2 ? 2 : 0.5));
    const measured = { ...plain, fields: [{ ...field, per: 'vertex' as const, values }] };
    expect(measuresFor(measured).at(-1)).toMatchObject({ name: 'field-size', label: 'Change of size' });
    expect(measureOf(measured, 'field-size')).toMatchObject({
      summary: 'mostly ×0.5 to ×2',
      scale: { kind: 'factor', end: 2 },
    });
  });

  it('of faces are shown by their mean around each position', () => {
    const values = new Float64Array(ball.triangles.length / 3).fill(3);
    const measured = { ...plain, fields: [{ ...field, unit: '°', per: 'face' as const, values }] };
    const overlay = measureOf(measured, 'field-size')!;
    expect(overlay.scale).toEqual({ kind: 'rising', end: 3, unit: '°' });
    expect([...overlay.values]).toEqual(Array(count).fill(3));
  });
});

describe('scales', () => {
  it('have 0 or 1 in the middle and end where they say', () => {
    expect([-9, -4, 0, 2, 4].map((value) => shareOf(signed, value))).toEqual([0, 0, 0.5, 0.75, 1]);
    const shares = [0.25, 0.5, 1, Math.SQRT2, 2].map((value) => shareOf(factor, value));
    for (const [k, share] of [0, 0, 0.5, 0.75, 1].entries()) expect(shares[k]).toBeCloseTo(share, 12);
    expect(shareOf(rising, Number.NaN)).toBeNaN();
    expect([rising, signed, factor].map(rangeOf)).toEqual(['0 to 5°', '−4 to 4', '×0.5 to ×2']);
  });

  it('count signed values on both sides and NaN nowhere', () => {
    expect(histogram(signed, Float32Array.of(-9, -3, -1, 1, 1.5, Number.NaN), 4)).toEqual([2, 1, 2, 0]);
    expect(histogram(rising, Float32Array.of(0, 1, 2.5, 9), 5)).toEqual([1, 1, 1, 0, 1]);
  });

  it('bear lists with NaN or with nothing', () => {
    const values = Float32Array.of(3, Number.NaN, 1, 2);
    expect([mean(values), quantile(values, 1), quantile(values, 0)]).toEqual([2, 3, 1]);
    expect([mean([]), quantile([], 0.5)]).toEqual([0, 0]);
    expect([0.7, 1, 1.2, 34, 60].map(roundedUp)).toEqual([0.8, 1, 1.5, 40, 60]);
  });
});

describe('colours', () => {
  const light = (scale: Scale) =>
    Array.from({ length: 51 }, (_, k) => {
      const { r, g, b } = ramp(scale, k / 50);
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    });

  it('only get lighter, or lighter towards the neutral middle from both sides alike', () => {
    const up = (list: number[]) => expect(list).toEqual(list.toSorted((a, b) => a - b));
    up(light(rising));
    const both = light(signed);
    up(both.slice(0, 26));
    up(both.slice(25).reverse());
    both.forEach((value, k) => {
      expect(Math.abs(value - both[50 - k]!)).toBeLessThan(0.12);
    });
  });

  it('are of their own where there is no value', () => {
    const painted = rampColors(signed, Float32Array.of(0, Number.NaN));
    expect([...painted.subarray(3)]).toEqual([...Float32Array.from(blank.toArray())]);
  });
});

it('paints when the project, the choice or the comparing changes, and only then', () => {
  const store = newPageStore();
  let paints = 0;
  followOverlay(store, { setColors: () => paints++ });
  const project = projectOf(icosphere(1), {}, (x, i) => (i % 3 === 1 ? 1.2 * x : x));
  const look = store.state.look;
  store.set({ project });
  expect(paints).toBe(0);
  store.set({ look: { ...look, overlay: 'curvature-after' } });
  store.set({ activity: { kind: 'idle' } });
  expect([paints, store.state.overlay!.title]).toEqual([1, 'Gaussian curvature, after']);
  store.set({ look: { ...store.state.look, comparing: true } });
  expect([paints, store.state.overlay!.title]).toEqual([2, 'Gaussian curvature, before']);
  store.set({ look: { ...look, overlay: 'strength' } });
  expect([paints, store.state.overlay]).toEqual([3, null]);
});
