import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { convexHull } from '../../src/inputs/styles/convex-hull.ts';
import { normalsOfConvex } from '../../src/inputs/styles/convex-normals.ts';
import { jessen } from '../../src/inputs/styles/jessen.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { meshOf, type Surface, volume } from '../../src/inputs/styles/surface.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import { dot, doubledAreaVector, length, type Vec3 } from '../../src/mesh/vectors.ts';
import { icosphere, together } from '../fixtures/meshes.ts';
import { eulerCharacteristic, isClosedAndOriented } from '../fixtures/surfaces.ts';

const point = (coordinate: fc.Arbitrary<number>) => fc.tuple(coordinate, coordinate, coordinate);
const lattice = point(fc.integer({ min: -3, max: 3 })); // many in one plane, on one line, in one place
const anywhere = point(fc.double({ min: -1, max: 1, noNaN: true }).map((x) => Math.round(x * 1e6) / 1e6));

function hullOrFlat(points: readonly Vec3[]): ReturnType<typeof convexHull> | undefined {
  try {
    return convexHull(points);
  } catch (thrown) {
    expect(thrown).toMatchObject({ code: 'unsuitable-mesh' });
    return undefined;
  }
}

describe('the convex hull', () => {
  it.each([
    ['lattice points', lattice],
    ['any points', anywhere],
  ])('of %s holds them all, is closed and faces out', (_, points) => {
    fc.assert(
      fc.property(fc.array(points, { minLength: 0, maxLength: 40 }), (all) => {
        const hull = hullOrFlat(all);
        if (!hull) return;
        for (const [a, b, c] of hull) {
          const normal = doubledAreaVector(all[a]!, all[b]!, all[c]!);
          expect(length(normal)).toBeGreaterThan(0);
          for (const p of all) {
            const height = dot(normal, p) - dot(normal, all[a]!);
            expect(height).toBeLessThanOrEqual(1e-8 * length(normal) + 1e-12);
          }
        }
        const surface = {
          positions: Float64Array.from(all.flat()),
          triangles: Uint32Array.from(hull.flat()),
        };
        expect(isClosedAndOriented(surface)).toBe(true);
        expect(eulerCharacteristic(surface)).toBe(2);
        expect(volume(surface)).toBeGreaterThan(0);
      }),
      { seed: 2021, numRuns: 400 },
    );
  });

  it('does not depend on the order of the points', () => {
    fc.assert(
      fc.property(fc.array(lattice, { minLength: 4, maxLength: 30 }), (all) => {
        const hulls = [all, all.toReversed()].map((points) => {
          const hull = hullOrFlat(points);
          return hull && volume(meshOf(points, hull));
        });
        if (hulls[0] === undefined) expect(hulls[1]).toBeUndefined();
        else expect(hulls[1]).toBeCloseTo(hulls[0], 9);
      }),
      { seed: 2021, numRuns: 200 },
    );
  });

  it.each([
    ['no', []],
    [
      'three',
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
      ],
    ],
    ['equal', Array(9).fill([1, 2, 3])],
    ['collinear', [0, 1, 2, 3, 4].map((x) => [x, 2 * x, -x])],
    [
      'coplanar',
      [
        [0, 0, 1],
        [1, 0, 1],
        [0, 1, 1],
        [1, 1, 1],
        [0.5, 0.2, 1],
      ],
    ],
  ] as [string, Vec3[]][])('of %s points is refused', (_, points) => {
    expect(() => convexHull(points)).toThrowError(WhittleError);
  });
});

describe('normals of a convex mesh', () => {
  const refusal = (surface: Surface): WhittleError => {
    try {
      normalsOfConvex(surface);
    } catch (thrown) {
      if (thrown instanceof WhittleError) return thrown;
    }
    throw new Error('it was not refused');
  };

  it('join the triangles of a face, also where the file rounded its numbers', () => {
    const { positions, triangles } = findPrimitive('dodecahedron')!.mesh;
    const rounded = positions.map((x) => Math.round(x * 1000) / 1000);
    expect(normalsOfConvex({ positions: rounded, triangles }).length / 3).toBe(12);
  });

  it('do not need shared vertices or sound faces', () => {
    const { positions, triangles } = findPrimitive('cube')!.mesh;
    const apart = Float64Array.from(
      Array.from(triangles).flatMap((v) => [...positions.slice(3 * v, 3 * v + 3)]),
    );
    const corners = Uint32Array.from([...triangles.keys(), 0, 0, 1]);
    expect(normalsOfConvex({ positions: apart, triangles: corners }).length / 3).toBe(6);
  });

  it('put the largest face first', () => {
    expect([...normalsOfConvex(findPrimitive('square-pyramid')!.mesh).slice(0, 3)]).toEqual([0, -1, 0]);
  });

  it('are refused for a concave mesh, which says how far it is off and where', () => {
    const error = refusal(jessen(3));
    expect(error.code).toBe('unsuitable-mesh');
    expect(error.message).toMatch(/stand out over face \d+ by \d+\.\d % of its size \(1 % would do\)/);
    expect(error.element).toBeGreaterThanOrEqual(0);
  });

  it('are refused for a mesh inside out, two solids and one that is too smooth', () => {
    const { positions, triangles } = findPrimitive('cube')!.mesh;
    expect(refusal({ positions, triangles: triangles.toReversed() }).message).toMatch(/not convex/);
    const cube = { positions, triangles };
    const two = together({ mesh: cube, offset: [0, 0, 0] }, { mesh: cube, offset: [5, 0, 0] });
    expect(refusal(two).message).toMatch(/not convex/);
    expect(refusal(icosphere(5)).message).toMatch(/smooth/);
  });

  it('are refused where there is no face', () => {
    const none = { positions: new Float64Array(9), triangles: Uint32Array.of(0, 1, 2) };
    expect(refusal(none).message).toMatch(/no face/);
  });
});
