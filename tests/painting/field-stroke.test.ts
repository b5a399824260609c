import { describe, expect, test } from 'vitest';
import { directionOfPixel } from '../../src/inputs/fields/sphere-field.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { dot, row, type Vec3 } from '../../src/mesh/vectors.ts';
import { type FieldBrush, FieldStroke, SphereCanvas, SurfaceCanvas } from '../../src/painting/index.ts';
import { atOnce, mirrorMap, type SurfacePoint, selectableOf } from '../../src/selection/index.ts';
import { icosphere, together } from '../fixtures/meshes.ts';

const plain: FieldBrush = { operation: 'subtract', strength: 1, value: 0, radius: 0.4, hardness: 0.5 };
const filled = (count: number, value: number) => new Float64Array(count).fill(value);

const surfaceOf = (mesh: Pick<Mesh, 'positions' | 'triangles'>) =>
  atOnce(selectableOf({ ...mesh, hasUvs: false } as Mesh));
const ball = surfaceOf(icosphere(4));
/** The face that looks most in a direction, touched in its middle. */
function touchTowards(surface: typeof ball, towards: Vec3): SurfacePoint {
  const { triangles } = surface.topology;
  let best = 0;
  let most = -Infinity;
  for (let face = 0; face < triangles.length / 3; face++) {
    const high = [0, 1, 2].reduce(
      (sum, k) => sum + dot(row(surface.places, triangles[3 * face + k]!), towards),
      0,
    );
    if (high > most) [best, most] = [face, high];
  }
  return { face: best, weights: [1 / 3, 1 / 3, 1 / 3] };
}

describe('a stroke on a surface', () => {
  const canvas = new SurfaceCanvas(ball);
  const top = touchTowards(ball, [0, 1, 0]);
  const begin = (change: Partial<FieldBrush>, base = filled(canvas.count, 0.5)) =>
    new FieldStroke(canvas, base, { ...plain, ...change });

  test('adds, takes away, sets and erases, by its strength, and leaves what it began with', () => {
    const base = filled(canvas.count, 0.5);
    const middle = ball.topology.triangles[3 * top.face]!;
    const brushed = (change: Partial<FieldBrush>) => {
      const stroke = begin(change, base);
      const touched = stroke.touch(top);
      expect(touched.length).toBeGreaterThan(20);
      expect(new Set(touched).size).toBe(touched.length);
      // Nothing changed that was not touched.
      const others = new Set(touched);
      stroke.values.forEach((value, v) => {
        if (!others.has(v) && value !== 0.5) throw new Error(`vertex ${v}`);
      });
      return stroke.values[middle]!;
    };
    expect(brushed({ operation: 'add', strength: 0.3 })).toBeCloseTo(0.8, 12);
    expect(brushed({ operation: 'subtract', strength: 0.3 })).toBeCloseTo(0.2, 12);
    expect(brushed({ operation: 'subtract' })).toBe(0);
    expect(brushed({ operation: 'add' })).toBe(1);
    expect(brushed({ operation: 'set', value: 0.25 })).toBe(0.25);
    expect(brushed({ operation: 'set', value: 0, strength: 0.5 })).toBe(0.25);
    expect(brushed({ operation: 'erase' })).toBe(1);
    expect(base.every((value) => value === 0.5)).toBe(true);
  });

  test('is no stronger where it crosses itself, and weaker under a light hand', () => {
    const stroke = begin({ strength: 0.4 });
    stroke.touch(top, 0.5);
    const light = stroke.values.slice();
    expect(Math.min(...light)).toBeCloseTo(0.3, 12);
    expect(stroke.touch(top, 0.5)).toEqual([]);
    stroke.touch(top);
    expect(Math.min(...stroke.values)).toBeCloseTo(0.1, 12);
  });

  test('smooths towards the neighbours, the more the longer it stays, and keeps what is even', () => {
    const spot = filled(canvas.count, 0);
    const middle = ball.topology.triangles[3 * top.face]!;
    spot[middle] = 1;
    const stroke = begin({ operation: 'smooth', strength: 0.5 }, spot);
    const seen = [1];
    for (let k = 0; k < 4; k++) {
      stroke.touch(top);
      seen.push(stroke.values[middle]!);
    }
    for (let k = 1; k < seen.length; k++) expect(seen[k]!).toBeLessThan(seen[k - 1]!);
    expect(Math.min(...stroke.values)).toBe(0);
    const even = begin({ operation: 'smooth' });
    even.touch(top);
    for (const value of even.values) expect(value).toBeCloseTo(0.5, 12);
  });

  test('does not go through to what only touches it', () => {
    const small = icosphere(3);
    const pair = surfaceOf(
      together({ mesh: small, offset: [0, 0, 0] }, { mesh: small, offset: [0, 2.01, 0] }),
    );
    const half = pair.topology.vertices / 2;
    const both = new SurfaceCanvas(pair);
    const stroke = new FieldStroke(both, filled(both.count, 1), plain);
    // The top of the lower ball, next to the bottom of the upper one.
    const lower = touchTowards(surfaceOf(small), [0, 1, 0]);
    stroke.touch(lower);
    expect(stroke.values.subarray(0, half).some((value) => value < 1)).toBe(true);
    expect(stroke.values.subarray(half).every((value) => value === 1)).toBe(true);
  });

  test('mirrored it is the same on both sides, to the bit, and smooths alike', () => {
    const mirror = atOnce(mirrorMap(ball.places, 0));
    expect(mirror.alone).toBe(0);
    const mirrored = new SurfaceCanvas(ball, mirror);
    for (const operation of ['subtract', 'smooth'] as const) {
      const base = ball.places.filter((_, k) => k % 3 === 1).map((y) => 0.5 + 0.4 * Math.sin(9 * y));
      const even = base.map((value, v) => (value + base[mirror.partner[v]!]!) / 2);
      const stroke = new FieldStroke(mirrored, even, { ...plain, operation, strength: 0.6 });
      for (const towards of [
        [1, 0.4, 0.2],
        [0.9, 0.5, 0.2],
        [0.1, 0.9, 0.1],
      ] as const)
        stroke.touch(touchTowards(ball, towards));
      const changed = stroke.values.filter((value, v) => value !== even[v]).length;
      expect(changed).toBeGreaterThan(100);
      stroke.values.forEach((value, v) => {
        if (Math.abs(stroke.values[mirror.partner[v]!]! - value) > (operation === 'smooth' ? 1e-12 : 0))
          throw new Error(`vertex ${v}`);
      });
    }
  });
});

describe('a stroke on the sphere of directions', () => {
  const height = 32;
  const brush: FieldBrush = { ...plain, radius: Math.PI / 6 };

  test('reaches what looks nearly there, over the edge of the picture and over the poles', () => {
    const canvas = new SphereCanvas(height);
    for (const towards of [
      [0, 0, -1],
      [0, 1, 0],
      [0, -1, 0],
      [0.6, 0.8, 0],
    ] as Vec3[]) {
      const stroke = new FieldStroke(canvas, filled(canvas.count, 1), brush);
      stroke.touch(towards);
      stroke.values.forEach((value, place) => {
        const cosine = dot(
          directionOfPixel(place % (2 * height), Math.floor(place / (2 * height)), height),
          towards,
        );
        if (value < 1 !== Math.cos(brush.radius) < cosine - 1e-12) throw new Error(`pixel ${place}`);
      });
    }
  });

  test('mirrors left and right, and smooths over its edges', () => {
    const canvas = new SphereCanvas(height, true);
    const stroke = new FieldStroke(canvas, filled(canvas.count, 1), brush);
    stroke.touch([0.8, 0.6, 0]);
    const width = 2 * height;
    stroke.values.forEach((value, place) => {
      expect(stroke.values[place - (place % width) + (width - 1 - (place % width))]).toBe(value);
    });
    expect(Math.min(...stroke.values)).toBe(0);
    const again = new FieldStroke(canvas, stroke.values, { ...brush, operation: 'smooth' });
    for (const towards of [
      [0, 0, -1],
      [0, 1, 0],
    ] as Vec3[])
      again.touch(towards);
    expect(again.values.every((value) => value >= 0 && value <= 1)).toBe(true);
    for (let place = 0; place < canvas.count; place++) {
      const near: number[] = [];
      canvas.neighbours(place, (other) => near.push(other));
      expect(near).toHaveLength(4);
      for (const other of near) {
        const back: number[] = [];
        canvas.neighbours(other, (one) => back.push(one));
        expect(back).toContain(place);
      }
    }
  });
});
