import { beforeAll, describe, expect, it } from 'vitest';
import { lookup } from '../../src/inputs/styles/gauss-lookup.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { bunny, icosphere, type TestMesh } from '../fixtures/meshes.ts';
import { risesOf, run } from '../fixtures/runs.ts';
import { plate } from '../fixtures/shapes.ts';
import { eightPrimitives, meanAngle, restyle } from '../fixtures/style-angles.ts';
import { bends, cornerAngles, eulerCharacteristic, faceVectors } from '../fixtures/surfaces.ts';
import { type NamedMesh, tenMeshes } from '../fixtures/ten-meshes.ts';

/** What the paper of 2021 claims and shows, held with numbers. */

const regularizers = ['arap', 'farap', 'acap'] as const;
type Regularizer = (typeof regularizers)[number];
const styleOf = (primitive: string) =>
  ({ kind: 'closest', normals: findPrimitive(primitive)!.normals }) as const;
const meanOf = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;

let meshes: readonly NamedMesh[];
beforeAll(async () => {
  meshes = await tenMeshes();
});

describe('Fig. 13 to 15: on ten meshes', () => {
  it('are of all kinds', () => {
    const characteristics = meshes.map(({ mesh }) => eulerCharacteristic(mesh));
    expect(characteristics).toContain(2); // closed
    expect(characteristics).toContain(1); // a sheet
    expect(characteristics).toContain(0); // a ring, or open at two ends
    expect(characteristics).toContain(-2); // two handles
    expect(meshes).toHaveLength(10);
  });

  it.each(eightPrimitives)(
    'the angle to the targets of a %s falls by a fifth at least',
    async (primitive) => {
      for (const { name, mesh } of meshes) {
        const { before, after, run } = await restyle(mesh, primitive);
        expect(after, name).toBeLessThan(0.8 * before);
        expect(risesOf(run), name).toBe(0);
      }
    },
  );

  it.each(regularizers)('the energy of %s falls at every step, accelerated or not', async (regularizer) => {
    for (const { name, mesh } of meshes)
      for (const acceleration of ['none', 'nesterov']) {
        const settings = { regularizer, acceleration, lambda: 1, maxIterations: 25 };
        const result = await run(mesh, 'analogy', { style: styleOf('dodecahedron'), ...settings });
        expect(risesOf(result), `${name}, ${acceleration}`).toBe(0);
        expect(result.energy.at(-1)!, name).toBeLessThan(result.energy[0]!);
      }
  });
});

describe('Fig. 6: a ball in the style of a cube is a cube', () => {
  /** From a point to the surface of the cube about the origin with half side `half`. */
  const toCube = (x: number, y: number, z: number, half: number): number => {
    const beyond = [x, y, z].map((value) => Math.abs(value) - half);
    const most = Math.max(...beyond);
    return most <= 0 ? -most : Math.hypot(...beyond.map((value) => Math.max(0, value)));
  };

  const distances = ({ positions }: TestMesh, half: number): number[] =>
    Array.from({ length: positions.length / 3 }, (_, v) =>
      toCube(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!, half),
    );

  /** From the points of a cube to the nearest vertex, at most. */
  const farthestCubePoint = ({ positions }: TestMesh, half: number): number => {
    let farthest = 0;
    const steps = [-1, -0.8, -0.6, -0.4, -0.2, 0, 0.2, 0.4, 0.6, 0.8, 1];
    for (const a of steps)
      for (const b of steps)
        for (const [x, y, z] of [
          [a, b, 1],
          [1, a, b],
          [b, -1, a],
        ] as const) {
          let nearest = Infinity;
          for (let i = 0; i < positions.length; i += 3) {
            const off = [
              x * half - positions[i]!,
              y * half - positions[i + 1]!,
              z * half - positions[i + 2]!,
            ];
            nearest = Math.min(nearest, Math.hypot(...off));
          }
          farthest = Math.max(farthest, nearest);
        }
    return farthest;
  };

  it.each(regularizers)('with %s, to 0.035 of its side, its corners to 0.1', async (regularizer) => {
    const ball = icosphere(4);
    const settings = { style: styleOf('cube'), lambda: 10, tolerance: 1e-4, regularizer };
    const { positions } = await run(ball, 'analogy', settings);
    const shape = { ...ball, positions };
    const halves = Array.from({ length: 80 }, (_, k) => 0.6 + 0.004 * k);
    const errors = halves.map((half) => meanOf(distances(shape, half).map((distance) => distance ** 2)));
    const half = halves[errors.indexOf(Math.min(...errors))]!;
    expect(Math.sqrt(Math.min(...errors)) / (2 * half)).toBeLessThan(0.007);
    expect(Math.max(...distances(shape, half)) / (2 * half)).toBeLessThan(0.035);
    expect(farthestCubePoint(shape, half) / (2 * half)).toBeLessThan(0.1);
  });
});

describe('Fig. 11: a sheet pulled up in the middle, its boundary shrunk', () => {
  const size = 25;
  const sheet = plate(size);

  const handles = () => {
    const vertices: number[] = [];
    const targets: [number, number, number][] = [];
    for (let v = 0; v < size * size; v++) {
      const [x, y] = [sheet.positions[3 * v]! - 0.5, sheet.positions[3 * v + 1]! - 0.5];
      const out = Math.max(Math.abs(x), Math.abs(y));
      if (out > 0.5 - 1e-9) targets.push([0.8 * x, 0.8 * y, 0]);
      else if (out < 0.09) targets.push([x, y, 0.35]);
      else continue;
      vertices.push(v);
    }
    return { vertices, targets };
  };

  /** What there is to see of a result, over faces of which nothing is held; angles in degrees. */
  async function look(regularizer: Regularizer) {
    const held = handles();
    const settings = { regularizer, handles: held, tolerance: 1e-5, maxIterations: 2000 };
    const { positions } = await run(sheet, 'arap', settings as ParameterValues);
    const isHeld = new Set(held.vertices);
    const triangles = sheet.triangles.filter((_, corner) => {
      const face = corner - (corner % 3);
      return [0, 1, 2].every((k) => !isHeld.has(sheet.triangles[face + k]!));
    }) as TestMesh['triangles'];
    const [rest, shape] = [
      { positions: sheet.positions, triangles },
      { positions, triangles },
    ];
    const angles = cornerAngles(rest);
    const areas = faceVectors(rest).map((vector) => Math.hypot(...vector));
    const scales = faceVectors(shape).map((vector, face) => Math.sqrt(Math.hypot(...vector) / areas[face]!));
    const logs = scales.map(Math.log);
    const usual = meanOf(logs);
    return {
      bend: meanOf(bends(shape)),
      sharp: bends(shape).filter((bend) => bend > 30).length / bends(shape).length,
      angleError: meanOf(cornerAngles(shape).map((angle, corner) => Math.abs(angle - angles[corner]!))),
      /** How far local scales are from each other: the deviation of their logarithms. */
      scaleSpread: Math.sqrt(meanOf(logs.map((log) => (log - usual) ** 2))),
      largest: Math.max(...scales),
    };
  }

  it('is smooth with arap, bends sharply between triangles with farap, keeps angles while sizes vary with acap', async () => {
    const [arap, farap, acap] = [await look('arap'), await look('farap'), await look('acap')];
    expect(arap.sharp).toBe(0);
    expect(arap.bend).toBeLessThan(6);
    expect(farap.sharp).toBeGreaterThan(0.2);
    expect(farap.bend).toBeGreaterThan(4 * arap.bend);
    expect(acap.sharp).toBe(0);
    expect(acap.angleError).toBeLessThan(0.85 * arap.angleError);
    expect(acap.scaleSpread).toBeGreaterThan(1.8 * arap.scaleSpread);
    expect(acap.scaleSpread).toBeGreaterThan(4 * farap.scaleSpread);
    expect(acap.largest).toBeGreaterThan(arap.largest + 0.1);
  });
});

describe('Fig. 12: targets that stay and targets that follow, on the bunny', () => {
  it.each([
    ['cube', 'arap'],
    ['cube', 'farap'],
    ['tetrahedron', 'farap'],
    ['octahedron', 'arap'],
    ['icosahedron', 'farap'],
  ])(
    'in the style of a %s (%s) following goes further, most of all at the ears',
    async (primitive, regularizer) => {
      const mesh = bunny();
      const settings = {
        style: styleOf(primitive),
        lambda: 1,
        regularizer,
        tolerance: 1e-3,
        maxIterations: 300,
      };
      const fixed = await run(mesh, 'analogy', { ...settings, acceleration: 'none' });
      const following = await run(mesh, 'analogy', { ...settings, dynamicTargets: true });
      const target = lookup(settings.style);
      // To the closest direction of what has become of each face, whatever it was drawn to.
      const angle = ({ positions }: { positions: TestMesh['positions'] }) =>
        meanAngle({ ...mesh, positions }, { ...mesh, positions }, target);
      expect(angle(fixed)).toBeLessThan(0.85 * angle(mesh));
      expect(angle(following)).toBeLessThan(0.96 * angle(fixed));

      const heights = mesh.positions.filter((_, i) => i % 3 === 1);
      const [low, high] = [Math.min(...heights), Math.max(...heights)];
      const apart = Array.from(heights, (_, v) =>
        Math.hypot(...[0, 1, 2].map((k) => fixed.positions[3 * v + k]! - following.positions[3 * v + k]!)),
      );
      const isEar = (v: number) => heights[v]! > low + 0.72 * (high - low);
      const ears = meanOf(apart.filter((_, v) => isEar(v)));
      const body = meanOf(apart.filter((_, v) => !isEar(v)));
      expect(ears).toBeGreaterThan(1.3 * body);
      expect(ears / (high - low)).toBeGreaterThan(0.004);
    },
  );
});
