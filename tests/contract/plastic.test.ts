import { describe, expect, test } from 'vitest';
import { add, distance, row, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import { bunny, icosphere, type TestMesh } from '../fixtures/meshes.ts';
import { run } from '../fixtures/runs.ts';

const place = ({ positions }: TestMesh, v: number) => row(positions, v);

const vertices = ({ positions }: TestMesh) => [...Array(positions.length / 3).keys()];

function diagonal({ positions }: TestMesh): number {
  const sides = [0, 1, 2].map((axis) => {
    const along = positions.filter((_, index) => index % 3 === axis);
    return Math.max(...along) - Math.min(...along);
  });
  return Math.hypot(...sides);
}

/** The vertex that lies lowest, and the one that lies highest. */
function ends(mesh: TestMesh): readonly [number, number] {
  const byHeight = vertices(mesh).sort((a, b) => place(mesh, a)[1] - place(mesh, b)[1]);
  return [byHeight[0]!, byHeight.at(-1)!];
}

describe('plastic on the bunny', () => {
  test('one landmark held and one that asks for half as much again grow all of it by that (Fig. 17)', async () => {
    const mesh = bunny();
    const [foot, ear] = ends(mesh);
    const from = place(mesh, foot);
    const grown = (v: number): Vec3 => add(from, scale(subtract(place(mesh, v), from), 1.5));
    const { positions } = await run(mesh, 'plastic', {
      landmarks: { vertices: [ear], targets: [grown(ear)], fixed: [foot] },
      radius: 1,
    });
    const squares = vertices(mesh).map((v) => distance(grown(v), row(positions, v)) ** 2);
    const off = Math.sqrt(squares.reduce((sum, square) => sum + square, 0) / squares.length);
    expect((100 / diagonal(mesh)) * off).toBeLessThan(0.02);
  });

  test('an ear that is pulled far comes there in a few iterations, and what is fixed stays to the bit', async () => {
    const mesh = bunny();
    const [foot, ear] = ends(mesh);
    const size = diagonal(mesh);
    const fixed = vertices(mesh).filter((v) => place(mesh, v)[1] < place(mesh, foot)[1] + 0.05 * size);
    const [x, y, z] = place(mesh, ear);
    const target = [x + 0.2 * size, y + 0.25 * size, z] as const;
    const { positions, energy } = await run(mesh, 'plastic', {
      landmarks: { vertices: [ear], targets: [target], fixed },
    });
    expect(energy.length).toBeLessThanOrEqual(7);
    expect((100 / size) * distance(target, row(positions, ear))).toBeLessThan(0.02);
    for (const v of fixed) expect(row(positions, v)).toEqual(place(mesh, v));
  });
});

test('vertices listed as fixed are held by every method that takes handles', async () => {
  const mesh = icosphere(2);
  const [low, high] = ends(mesh);
  const [x, y, z] = place(mesh, high);
  const targets = [[x, y + 1, z]] as const;
  const listed = await run(mesh, 'arap', { handles: { vertices: [high], targets, fixed: [low] } });
  const spelledOut = await run(mesh, 'arap', {
    handles: { vertices: [high, low], targets: [...targets, place(mesh, low)] },
  });
  expect(listed.positions).toEqual(spelledOut.positions);
});
