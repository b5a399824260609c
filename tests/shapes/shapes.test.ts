import { describe, expect, test } from 'vitest';
import {
  cornerAngles,
  eulerCharacteristic,
  isClosedAndOriented,
  volumeInside,
} from '../fixtures/surfaces.ts';
import { asDrawn, caseOf, cases, meshed } from './cases.ts';
import { stretched } from './gestures.ts';
import { part } from './shape.ts';

/** Holes through the body that a handle, a bore or a ring makes; the shapes else are like a ball. */
const holes: Record<string, number> = { 'drilled plate': 5, bracket: 1, nut: 1, mug: 1, ring: 1 };
const parts = (name: string) => (/^(pin|block)/.test(name) ? 2 : 1);
/** One hole in the plate, two bodies. */
const expected = (name: string) => 2 * parts(name) - 2 * (holes[name] ?? (name.startsWith('pin') ? 1 : 0));

describe.each(cases)('$name', (made) => {
  const isOpen = made.name === 'hemisphere';

  test.each([1, 2])('is closed and its faces are even at mesh scale %d', (scale) => {
    const shape = meshed(made, scale);
    if (!isOpen) {
      expect(isClosedAndOriented(shape)).toBe(true);
      expect(eulerCharacteristic(shape)).toBe(expected(made.name));
      expect(volumeInside(shape)).toBeGreaterThan(0);
    }
    const angles = cornerAngles(shape).toSorted((a, b) => a - b);
    expect(angles[Math.floor(0.02 * angles.length)]).toBeGreaterThan(scale === 1 ? 20 : 14);
  });

  test('has the parts that its gestures name, and round parts', () => {
    const shape = meshed(made, 2);
    for (const gesture of Object.values(made.gestures)) {
      expect(stretched(shape, gesture).vertices.length).toBeGreaterThanOrEqual(2);
      expect(part(shape, gesture.moved).length).toBeGreaterThan(0);
    }
    for (const { name, vertices } of shape.rounds) expect(vertices.length, name).toBeGreaterThanOrEqual(10);
    for (const name of shape.bevels) expect(part(shape, name).length).toBeGreaterThanOrEqual(4);
  });

  test.runIf(made.isDrawn)('is closed as drawn, and as large', () => {
    const shape = asDrawn(made);
    expect(isClosedAndOriented(shape)).toBe(true);
    expect(eulerCharacteristic(shape)).toBe(expected(made.name));
    expect(volumeInside(shape)).toBeCloseTo(volumeInside(meshed(made, 2)), 0);
  });
});

test('as drawn, plates have slivers', () => {
  const plate = asDrawn(caseOf('drilled plate'));
  expect(Math.min(...cornerAngles(plate))).toBeLessThan(1);
  expect(plate.triangles.length).toBeLessThan(meshed(caseOf('drilled plate')).triangles.length / 4);
});
