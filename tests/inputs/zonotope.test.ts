import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { zonotopeFaces } from '../../src/inputs/styles/zonotope.ts';
import { dot, type Vec3 } from '../../src/mesh/vectors.ts';
import { cubic } from '../../src/methods/cubic.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';

const polyhedra = cubic.parameters.find(({ name }) => name === 'polyhedron') as ChoiceParameter;

describe('the polyhedron of rows', () => {
  it.each([
    ['cube', 6],
    ['hexagonal-prism', 8],
    ['rhombic-dodecahedron', 12],
    ['truncated-octahedron', 14],
  ] as const)('is a %s of %d faces', (name, faces) => {
    expect(zonotopeFaces(polyhedra.rows![name]! as readonly Vec3[])).toHaveLength(faces);
  });

  it('is as wide along any direction as the norm that it stands for', () => {
    const part = fc.double({ min: -2, max: 2, noNaN: true });
    const row = fc.tuple(part, part, part).filter((r) => Math.hypot(...r) > 0.1);
    fc.assert(
      fc.property(fc.array(row, { minLength: 3, maxLength: 7 }), row, (rows, p) => {
        const corners = zonotopeFaces(rows).flatMap((face) => face.corners);
        fc.pre(corners.length > 0);
        const reach = Math.max(...corners.map((corner) => dot(corner, p)));
        const norm = rows.reduce((sum, b) => sum + Math.abs(dot(b, p)), 0);
        expect(2 * reach).toBeCloseTo(norm, 4);
      }),
    );
  });

  it('has flat faces that look outwards', () => {
    for (const rows of Object.values(polyhedra.rows!)) {
      for (const { normal, corners } of zonotopeFaces(rows as readonly Vec3[])) {
        const heights = corners.map((corner) => dot(corner, normal));
        expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(1e-12);
        expect(heights[0]).toBeGreaterThan(0);
      }
    }
  });

  it('joins parallel rows and has no face where all lie in a plane', () => {
    const box = zonotopeFaces([
      [1, 0, 0],
      [-1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ]);
    expect(box).toHaveLength(6);
    expect(Math.max(...box.flatMap(({ corners }) => corners.map(([x]) => x)))).toBe(1);
    expect(
      zonotopeFaces([
        [1, 0, 0],
        [0, 1, 0],
        [1, 1, 0],
      ]),
    ).toEqual([]);
  });
});
