import { angleAfter, angleBefore } from './angle.ts';
import { curvatureAfter, curvatureBefore } from './curvature.ts';
import { fieldMeasure } from './field.ts';
import { growth } from './growth.ts';
import type { LineField, Measure, Measured, Overlay, OverlayName, ScalarField } from './measure.ts';
import { movement } from './movement.ts';
import { strength } from './strength.ts';
import { turn } from './turn.ts';

export type {
  LineField,
  Measure,
  Measured,
  NormalTargets,
  Overlay,
  OverlayName,
  ScalarField,
} from './measure.ts';

/** All ways to look closer, in the order in which the page offers them. */
const measures: readonly Measure[] = [
  angleBefore,
  angleAfter,
  curvatureBefore,
  curvatureAfter,
  movement,
  growth,
  turn,
  strength,
];

/** The ways to look closer that make sense here. */
export function measuresFor(measured: Measured): readonly Measure[] {
  return [...measures.filter(({ suits }) => suits(measured)), ...numbersOf(measured).map(fieldMeasure)];
}

/** The lines that can be drawn over the mesh. */
export function linesFor({ fields }: Measured): readonly LineField[] {
  return fields.filter((field): field is LineField => field.per === 'line' && field.values.length > 0);
}

function numbersOf({ fields }: Measured): readonly ScalarField[] {
  return fields.filter((field): field is ScalarField => field.per !== 'line');
}

/**
 * Measures a mesh by one of them; null where there is nothing to measure (no result yet, no style).
 *
 * @param comparing the file's own shape is on the screen: what has a measure of it is that one
 */
export function measure(measured: Measured, name: OverlayName, comparing = false): Overlay | null {
  const all = [...measures, ...numbersOf(measured).map(fieldMeasure)];
  const chosen = all.find((one) => one.name === name);
  const wanted = comparing && chosen?.before ? measures.find((one) => one.name === chosen.before) : chosen;
  return wanted?.suits(measured) ? wanted.of(measured) : null;
}
