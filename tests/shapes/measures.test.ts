import { describe, expect, test } from 'vitest';
import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { caseOf, meshed } from './cases.ts';
import { movedBy, stretched } from './gestures.ts';
import { Judge, type Measures } from './measures.ts';
import { oblique, type Shape, turned } from './shape.ts';

const plate = meshed(caseOf('drilled plate'), 2);
const box = meshed(caseOf('chamfered box'), 2);
const none: Handles = { vertices: [], targets: [] };

/** What is measured of a shape whose points went elsewhere. */
function measured(shape: Shape, to: (at: Vec3, vertex: number) => Vec3, handles = none): Measures {
  const positions = shape.positions.slice();
  for (let v = 0; 3 * v < positions.length; v++) positions.set(to(row(positions, v), v), 3 * v);
  return new Judge(shape).measure(positions, handles);
}

describe('measures', () => {
  test('of what has not changed say so', () => {
    const { rounds, bevels, quality, ...rest } = measured(plate, (at) => at);
    for (const { ratio, roundness } of rounds) {
      expect(ratio).toBeCloseTo(1, 9);
      expect(roundness).toBeLessThan(1e-9);
    }
    expect(rounds.length).toBe(5);
    expect(quality).toBeCloseTo(1, 9);
    for (const [name, value] of Object.entries(rest)) expect(value, name).toBeLessThan(1e-5);
  });

  test.each([plate, box])('of a plain stretch are what one reckons', (shape) => {
    const { rounds, bevels, ...rest } = measured(shape, ([x, y, z]) => [1.6 * x, y, z]);
    // A circle that becomes an ellipse with half axes 1.6 and 1: its circle is of their mean size, its deviation (a − b)/2√2.
    for (const { ratio, roundness } of rounds) {
      expect(ratio).toBeCloseTo(1.3, 1);
      expect(roundness).toBeCloseTo(0.3 / Math.SQRT2 / 1.3, 1);
    }
    for (const { ratio } of bevels) expect(ratio).toBeCloseTo(1, 6);
    expect(rest.flipped).toBe(0);
    expect(rest.thickness).toBeLessThan(1e-6);
    expect(rest.lineBend).toBeLessThan(1e-9);
    expect(rest.stretchJump).toBeLessThan(0.2);
    expect(rest.quality).toBeGreaterThan(0.65);
  });

  test('of bevels that are widened say by how much', () => {
    for (const { ratio } of measured(box, ([x, y, z]) => [x, 1.2 * y, 1.2 * z]).bevels)
      expect(ratio).toBeCloseTo(1.2, 6);
  });

  test('see a bend, a tilt, a change of thickness and a jump', () => {
    const bent = measured(plate, ([x, y, z]) => [x, y, z + 0.02 * x * x]);
    expect(bent.lineBend * Math.hypot(4, 2, 0.4)).toBeCloseTo(0.02 * 4 * 4 * 0.15, 1);
    expect(bent.planeTilt).toBeGreaterThan(3);
    const sheared = measured(plate, ([x, y, z]) => [x, y, z + 0.1 * x]);
    expect(sheared.planeTilt).toBeCloseTo((Math.atan(0.1) * 180) / Math.PI, 3);
    expect(sheared.normalMax).toBeGreaterThan(5);
    expect(measured(plate, ([x, y, z]) => [x, y, 1.25 * z]).thickness).toBeCloseTo(0.25, 6);
    const uneven = measured(plate, ([x, y, z]) => [x < 2 ? x : 2 + 2 * (x - 2), y, z]);
    expect(uneven.stretchJump).toBeGreaterThan(
      1.3 * measured(plate, ([x, y, z]) => [1.5 * x, y, z]).stretchJump,
    );
  });

  test('see what is turned inside out', () => {
    expect(measured(plate, ([x, y, z]) => [-x, y, z]).flipped).toBeGreaterThan(0);
    expect(measured(plate, ([x, y, z]) => [x, y, -z]).flipped).toBeGreaterThan(
      0.4 * (plate.triangles.length / 3),
    );
  });

  test('are those of the shape wherever it lies', () => {
    const bend = ([x, y, z]: Vec3): Vec3 => [x * (1 + 0.1 * y), y, z + 0.02 * x * x];
    const straight = measured(plate, bend);
    const moved = plate.positions.slice();
    for (let v = 0; 3 * v < moved.length; v++) moved.set(bend(row(moved, v)), 3 * v);
    const positions = turned({ ...plate, positions: moved }, oblique).positions;
    const there = new Judge(turned(plate, oblique)).measure(positions, none);
    for (const key of [
      'normalMax',
      'planeTilt',
      'lineBend',
      'quality',
      'stretchJump',
      'thickness',
    ] as const) {
      // Shares of the diagonal of a box that lies otherwise differ with that.
      expect(there[key], key).toBeCloseTo(straight[key], key === 'lineBend' || key === 'thickness' ? 2 : 5);
    }
    for (const [k, { ratio }] of there.rounds.entries())
      expect(ratio).toBeCloseTo(straight.rounds[k]!.ratio, 6);
  });

  test('say how far a handle is from where it was to go', () => {
    const handles = stretched(plate, { held: 'left', moved: 'right', factor: 1.5 });
    const way = 2 / Math.hypot(4, 2, 0.4);
    expect(measured(plate, (at) => at, handles).handle).toBeCloseTo(way, 6);
    expect(measured(plate, ([x, y, z]) => [1.5 * x, y, z], handles).handle).toBeLessThan(1e-9);
    expect(movedBy(plate, [3], [0, 0, 1]).targets[0]![2]).toBe(plate.positions[11]! + 1);
  });
});
