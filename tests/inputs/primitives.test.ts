import { describe, expect, it } from 'vitest';
import { findPrimitive, primitiveIds, roundSides } from '../../src/inputs/styles/primitives.ts';
import { volume } from '../../src/inputs/styles/surface.ts';
import { length, row } from '../../src/mesh/vectors.ts';
import { eulerCharacteristic, isClosedAndOriented } from '../fixtures/surfaces.ts';

/** Vertices and face directions of every primitive, and its volume where a formula is handy. */
const known: Record<string, readonly [vertices: number, directions: number, volume?: number]> = {
  cube: [8, 6, 8],
  'bevelled-cube': [24, 26],
  tetrahedron: [4, 4, 8 / 3],
  octahedron: [6, 8, 4 / 3],
  dodecahedron: [20, 12, (2 * (15 + 7 * Math.sqrt(5))) / (2 + Math.sqrt(5))],
  icosahedron: [12, 20, (10 * (3 + Math.sqrt(5))) / 3],
  'truncated-octahedron': [24, 14, (4 / 3) * (8 / 9)],
  'truncated-icosahedron': [60, 32],
  'triangular-prism': [6, 5],
  'pentagonal-prism': [10, 7],
  'hexagonal-prism': [12, 8, 3 * Math.sqrt(3)],
  'octagonal-prism': [16, 10, 4 * Math.SQRT2],
  'hexagonal-bipyramid': [8, 12],
  'square-pyramid': [5, 5, 2 / 3],
  cone: [roundSides + 1, roundSides + 1],
  cylinder: [2 * roundSides, roundSides + 2],
};

it('lists every primitive', () => {
  expect([...primitiveIds].sort()).toEqual(Object.keys(known).sort());
  expect(findPrimitive('sphere')).toBeUndefined();
});

it('has each set of normals once, and takes the other solid’s name for it', () => {
  const sets = primitiveIds.map((id) => {
    const { normals } = findPrimitive(id)!;
    const rows = Array.from({ length: normals.length / 3 }, (_, n) =>
      row(normals, n).map((value) => (value + 0).toFixed(6).replace(/^-(0\.0+)$/, '$1')),
    );
    return rows.map(String).sort().join(' ');
  });
  expect(new Set(sets).size).toBe(sets.length);
  expect(findPrimitive('truncated-tetrahedron')).toBe(findPrimitive('octahedron'));
  expect(findPrimitive('truncated-cube')).toBe(findPrimitive('truncated-octahedron'));
});

describe.each(Object.entries(known))('%s', (id, [vertices, directions, volumeOf]) => {
  const { mesh, normals, name } = findPrimitive(id)!;

  it('is a closed solid, outside out', () => {
    expect(mesh.positions.length / 3).toBe(vertices);
    expect(isClosedAndOriented(mesh)).toBe(true);
    expect(eulerCharacteristic(mesh)).toBe(2);
    if (volumeOf !== undefined) expect(volume(mesh)).toBeCloseTo(volumeOf, 10);
    else expect(volume(mesh)).toBeGreaterThan(0.5);
    expect(name.toLowerCase().replaceAll(' ', '-')).toBe(id);
  });

  it('has its unit normals once each', () => {
    expect(normals.length / 3).toBe(directions);
    const rows = Array.from({ length: directions }, (_, n) => row(normals, n));
    for (const normal of rows) expect(length(normal)).toBeCloseTo(1, 12);
    const nearest = rows.flatMap((a, i) =>
      rows.slice(i + 1).map((b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]),
    );
    expect(Math.max(...nearest)).toBeLessThan(Math.cos(0.04));
  });
});
