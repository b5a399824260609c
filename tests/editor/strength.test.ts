import { expect, test } from 'vitest';
import { sharesOf, withPaintedStrength, withShares } from '../../src/editor/strength.ts';
import { weld } from '../../src/mesh/weld.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';

/** Two triangles along a seam: the file stores its two ends twice. */
const seam = weld(
  Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
  Uint32Array.of(0, 1, 2, 3, 5, 4),
);
const step = (parameters: ParameterValues) => ({ method: 'cubic', parameters });

test('shares become λ of every position, and are the same when they are asked for again', () => {
  const shares = Float64Array.of(1, 0.5, 0, 0.25);
  const values = withShares(step({ lambda: 0.4 }), shares, seam);
  expect([...(values.lambdaPerVertex as Float64Array)]).toEqual([0.4, 0.2, 0, 0.2, 0, 0.1]);
  expect(sharesOf(step(values), seam)).toBe(shares);
  expect(withShares(step(values), null, seam)).toEqual({ lambda: 0.4 });
});

test('shares that came from a recipe are read from its numbers, those above λ as all of it', () => {
  const lambdaPerVertex = [0.4, 0.2, 0, 0.2, 0, 3];
  expect([...sharesOf(step({ lambda: 0.4, lambdaPerVertex }), seam)!]).toEqual([1, 0.5, 0, 1]);
  expect([...sharesOf(step({ lambdaPerVertex }), seam)!]).toEqual([1, 1, 0, 1]); // λ is 0.2 then
  expect(sharesOf(step({ lambda: 0.4 }), seam)).toBeNull();
  expect(sharesOf(step({ lambdaPerVertex: [] }), seam)).toBeNull();
});

test('what is painted follows λ, through 0 and back', () => {
  const shares = Float64Array.of(1, 0.5, 0, 0.25);
  const painted = step(withShares(step({ lambda: 0.4 }), shares, seam));
  const none = step(withPaintedStrength(painted, { ...painted.parameters, lambda: 0 }, seam));
  expect([...(none.parameters.lambdaPerVertex as Float64Array)]).toEqual(new Array(6).fill(0));
  const back = step(withPaintedStrength(none, { ...none.parameters, lambda: 2 }, seam));
  expect([...(back.parameters.lambdaPerVertex as Float64Array)]).toEqual([2, 1, 0, 1, 0, 0.5]);
  const other = { ...painted.parameters, tolerance: 0.1 };
  expect(withPaintedStrength(painted, other, seam)).toBe(other);
});
