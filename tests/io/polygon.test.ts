import { cpuUsage } from 'node:process';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { triangulate } from '../../src/io/polygon.ts';

type Point = readonly [number, number];

/** A polygon of the plane, put into space by a turn and a shift. */
function split(points: readonly Point[], turned = false) {
  const lift = ([x, y]: Point) => (turned ? [3 - 2 * y, x + 2 * y, 2 * x - y + 7] : [x, y, 0]);
  const positions = Float64Array.from(points.flatMap(lift));
  const corners = Uint32Array.from(points.keys());
  const { triangles, roughFaces } = triangulate(positions, {
    start: Uint32Array.of(0, points.length),
    corners,
  });
  return { triangles: Array.from(triangles), roughFaces };
}

const area = (a: Point, b: Point, c: Point) =>
  ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;

function polygonArea(points: readonly Point[]): number {
  return points.reduce((sum, b, i) => sum + area([0, 0], points.at(i - 1)!, b), 0);
}

/** n − 2 triangles, none turned over, that cover the polygon's area: together that means no overlap and no gap. */
function expectSplit(points: readonly Point[], turned = false) {
  const { triangles, roughFaces } = split(points, turned);
  expect(roughFaces).toBe(0);
  expect(triangles).toHaveLength(3 * (points.length - 2));
  const total = polygonArea(points);
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const piece = area(points[triangles[t]], points[triangles[t + 1]], points[triangles[t + 2]]);
    expect(piece * Math.sign(total)).toBeGreaterThan(-1e-12 * Math.abs(total));
    sum += piece;
  }
  expect(sum).toBeCloseTo(total, 9);
}

const circle = (n: number, radius: (i: number) => number): Point[] =>
  Array.from({ length: n }, (_, i) => {
    const angle = (2 * Math.PI * i) / n;
    return [radius(i) * Math.cos(angle), radius(i) * Math.sin(angle)];
  });

describe('polygons are split without overlap', () => {
  it('stars of any shape, both ways round, in any plane', () => {
    const radii = fc.array(fc.double({ min: 0.1, max: 10, noNaN: true }), { minLength: 3, maxLength: 40 });
    fc.assert(
      fc.property(radii, fc.boolean(), fc.boolean(), (r, backward, turned) => {
        const points = circle(r.length, (i) => r[i]);
        expectSplit(backward ? points.reverse() : points, turned);
      }),
      { numRuns: 500, seed: 5 },
    );
  });

  it.each<[string, Point[]]>([
    [
      'a dart',
      [
        [0, 0],
        [2, 1],
        [0, 2],
        [0.5, 1],
      ],
    ],
    [
      'a dart from its dent',
      [
        [0.5, 1],
        [0, 0],
        [2, 1],
        [0, 2],
      ],
    ],
    [
      'an L',
      [
        [0, 0],
        [2, 0],
        [2, 1],
        [1, 1],
        [1, 2],
        [0, 2],
      ],
    ],
    [
      'a square with corners in its sides',
      [
        [0, 0],
        [1, 0],
        [2, 0],
        [2, 1],
        [2, 2],
        [1, 2],
        [0, 2],
        [0, 1],
      ],
    ],
    [
      'a comb',
      [
        [0, 0],
        [7, 0],
        [7, 3],
        [6, 1],
        [5, 3],
        [4, 1],
        [3, 3],
        [2, 1],
        [1, 3],
        [0.5, 1],
        [0, 3],
      ],
    ],
    [
      'a frame whose hole is bridged',
      [
        [0, 0],
        [4, 0],
        [4, 4],
        [0, 4],
        [0, 0],
        [1, 1],
        [1, 3],
        [3, 3],
        [3, 1],
        [1, 1],
      ],
    ],
    [
      'a spiral',
      [
        [0, 0],
        [5, 0],
        [5, 5],
        [1, 5],
        [1, 2],
        [3, 2],
        [3, 3],
        [2, 3],
        [2, 4],
        [4, 4],
        [4, 1],
        [0, 1],
      ],
    ],
  ])('%s', (_, points) => {
    expectSplit(points);
    expectSplit(points, true);
  });

  it.each<[string, Point[]]>([
    [
      'all in one place',
      [
        [1, 1],
        [1, 1],
        [1, 1],
        [1, 1],
        [1, 1],
      ],
    ],
    [
      'all in a line',
      [
        [0, 0],
        [1, 0],
        [2, 0],
        [3, 0],
        [1.5, 0],
      ],
    ],
    [
      'a bow tie',
      [
        [0, 0],
        [2, 2],
        [2, 0],
        [0, 2],
        [-1, 5],
      ],
    ],
    ['a pentagram', [0, 2, 4, 1, 3].map((i) => circle(5, () => 1)[i])],
  ])('%s gives n − 2 triangles of its corners', (_, points) => {
    const { triangles } = split(points);
    expect(triangles).toHaveLength(3 * (points.length - 2));
    expect(triangles.every((corner) => corner < points.length)).toBe(true);
  });

  it('keeps triangles as they are, repeated corners too', () => {
    const faces = { start: Uint32Array.of(0, 3, 6), corners: Uint32Array.of(0, 1, 1, 1, 1, 1) };
    expect(Array.from(triangulate(new Float64Array(6), faces).triangles)).toEqual([0, 1, 1, 1, 1, 1]);
  });
});

describe('giant polygons', () => {
  const n = 100000;
  it.each([
    ['round', () => 1],
    ['a star', (i: number) => 1 + (i % 2)],
    ['a saw', (i: number) => 1 + (i % 7) / 10],
  ] as const)('%s: 100 000 corners in a second', (_, radius) => {
    const points = circle(n, radius);
    const start = cpuUsage();
    expect(split(points).triangles).toHaveLength(3 * (n - 2));
    expect(cpuUsage(start).user / 1000).toBeLessThan(2000);
  });
});
