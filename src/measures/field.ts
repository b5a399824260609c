import type { Mesh } from '../mesh/mesh.ts';
import type { Measure, Overlay, ScalarField } from './measure.ts';
import type { Scale } from './scale.ts';
import { quantile, roundedUp } from './statistics.ts';

/** A way to look at a field that the method itself tells. */
export function fieldMeasure(field: ScalarField): Measure {
  return {
    name: `field-${field.name}`,
    label: field.label,
    suits: () => true,
    of: ({ mesh }) => overlayOf(field, mesh),
  };
}

function overlayOf({ label, per, unit, values }: ScalarField, mesh: Mesh): Overlay {
  const byPosition = per === 'vertex' ? Float32Array.from(values) : meansOfFaces(values, mesh);
  const [low, high] = [quantile(byPosition, 0.05), quantile(byPosition, 0.95)].map((value) =>
    Number(value.toPrecision(2)),
  );
  return {
    title: label,
    summary: unit === '×' ? `mostly ×${low} to ×${high}` : `mostly ${low} to ${high}${unit}`,
    scale: scaleOf(byPosition, unit),
    values: byPosition,
  };
}

/** Factors lie around 1, other numbers around 0 or above it. */
function scaleOf(values: Float32Array, unit: string): Scale {
  if (unit === '×') {
    const spread = quantile(
      values.map((value) => Math.abs(Math.log(value))),
      0.95,
    );
    return { kind: 'factor', end: Number(Math.max(1.05, Math.exp(spread)).toPrecision(2)) };
  }
  const end = roundedUp(Math.max(1e-9, quantile(values.map(Math.abs), 0.95)));
  return { kind: values.some((value) => value < 0) ? 'signed' : 'rising', end, unit };
}

/** The mean over the faces around each position, #P; NaN where there are none. */
function meansOfFaces(values: Float64Array, { positions, triangles }: Mesh): Float32Array<ArrayBuffer> {
  const sums = new Float32Array(positions.length / 3);
  const counts = new Float32Array(sums.length);
  triangles.forEach((p, corner) => {
    sums[p] = sums[p]! + values[Math.floor(corner / 3)]!;
    counts[p] = counts[p]! + 1;
  });
  return sums.map((sum, p) => sum / counts[p]!);
}
