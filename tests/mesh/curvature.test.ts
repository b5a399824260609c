import { describe, expect, it } from 'vitest';
import { mixedAreas, ringAreas } from '../../src/mesh/areas.ts';
import { angleDefects, gaussianCurvature, ringsOf } from '../../src/mesh/curvature.ts';
import { bunny, icosphere, type TestMesh, together } from '../fixtures/meshes.ts';
import { family, openCylinder, patch, plate, pretzel, sail, torus } from '../fixtures/shapes.ts';
import { eulerCharacteristic } from '../fixtures/surfaces.ts';

const count = ({ positions }: TestMesh) => positions.length / 3;
const rings = (mesh: TestMesh) => ringsOf(mesh.triangles, count(mesh));
const curvature = (mesh: TestMesh) => gaussianCurvature(mesh.positions, rings(mesh));
const sum = (values: Iterable<number>) => [...values].reduce((total, value) => total + value, 0);
const areaOf = (mesh: TestMesh) => sum(ringAreas(mesh.positions, mesh.triangles)) / 3;

/** Three leaves on one edge: what is there once has no curvature. */
const book: TestMesh = {
  positions: Float64Array.of(0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1),
  triangles: Uint32Array.of(0, 1, 2, 0, 1, 3, 0, 1, 4),
};

/** A strip of which one end is turned over before it is joined to the other. */
function moebius(columns: number): TestMesh {
  const strip = patch({ columns, rows: 3 }, (s, t) => {
    const [turn, half] = [2 * Math.PI * s, Math.PI * s];
    const radius = 2 + (t - 0.5) * Math.cos(half);
    return [radius * Math.cos(turn), radius * Math.sin(turn), (t - 0.5) * Math.sin(half)];
  });
  const ends = [0, 1, 2].map((row) => [(row + 1) * columns - 1, (2 - row) * columns] as const);
  const triangles = strip.triangles.map((v) => ends.find(([last]) => last === v)?.[1] ?? v);
  return { positions: strip.positions, triangles: triangles as TestMesh['triangles'] };
}

describe('Gaussian curvature', () => {
  it('is 1 all over the unit sphere and falls with the square of the size', () => {
    const ball = icosphere(4);
    for (const value of curvature(ball)) expect(value).toBeCloseTo(1, 1);
    const large = { ...ball, positions: ball.positions.map((x) => 50 * x) };
    for (const value of curvature(large)) expect(value * 2500).toBeCloseTo(1, 1);
  });

  it('is positive outside of a torus, negative inside, as its formula says', () => {
    const [columns, rows] = [96, 48];
    const values = curvature(torus(columns, rows));
    values.forEach((value, v) => {
      const cosine = Math.cos((2 * Math.PI * Math.floor(v / columns)) / rows);
      expect(value).toBeCloseTo(cosine / (0.4 * (1 + 0.4 * cosine)), 1);
    });
  });

  it('is 0 on a plate and on a cylinder, and is not told at their boundaries', () => {
    for (const mesh of [plate(9), openCylinder(24, 9)]) {
      const inside = curvature(mesh).filter((value) => !Number.isNaN(value));
      expect(inside.length).toBe(mesh.positions.length / 3 === 81 ? 49 : 24 * 7);
      for (const value of inside) expect(Math.abs(value)).toBeLessThan(1e-9);
    }
    expect([...curvature(book)].every(Number.isNaN)).toBe(true);
  });

  it('is all at the corners of a cube, each a quarter of three sides', () => {
    const cube: TestMesh = {
      positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1),
      triangles: Uint32Array.of(
        ...[0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4],
        ...[1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7],
      ),
    };
    for (const defect of angleDefects(cube.positions, rings(cube))) expect(defect).toBeCloseTo(Math.PI / 2);
    for (const area of mixedAreas(cube.positions, cube.triangles)) expect(area).toBeCloseTo(0.75);
  });
});

describe('angle defects', () => {
  it.each([
    ['a ball', icosphere(2), 2],
    ['the bunny', bunny(), 2],
    ['a torus', torus(20, 12), 0],
    ['a pretzel', pretzel(1), -2],
    ['a sheet', sail(12), 1],
    ['an open cylinder', openCylinder(12, 5), 0],
    ['three parts', family(), 3],
    [
      'two balls',
      together({ mesh: icosphere(1), offset: [0, 0, 0] }, { mesh: icosphere(1), offset: [3, 0, 0] }),
      4,
    ],
    ['a Möbius strip', moebius(30), 0],
    ['three leaves on one edge', book, 1],
  ])('of %s sum to 2π times its Euler characteristic', (_, mesh, expected) => {
    expect(eulerCharacteristic(mesh)).toBe(expected);
    const used = new Set(mesh.triangles);
    const defects = angleDefects(mesh.positions, rings(mesh)).filter((_, v) => used.has(v));
    expect(sum(defects)).toBeCloseTo(2 * Math.PI * expected, 8);
  });

  it('bear faces that are none', () => {
    const ball = icosphere(2);
    const bad = { ...ball, triangles: Uint32Array.of(...ball.triangles, 5, 5, 7) };
    expect(angleDefects(bad.positions, rings(bad))).toEqual(angleDefects(ball.positions, rings(ball)));
  });
});

describe('areas', () => {
  it('are the whole surface together, and a ring is every face three times', () => {
    for (const mesh of [bunny(), sail(15), torus(30, 9)])
      expect(sum(mixedAreas(mesh.positions, mesh.triangles))).toBeCloseTo(areaOf(mesh), 9);
    expect(areaOf(plate(7))).toBeCloseTo(1, 12);
  });
});
