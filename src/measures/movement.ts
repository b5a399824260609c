import { type Measure, type Measured, positionsNow } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile } from './statistics.ts';

/** How far every place is from where the file has it, as a share of the mesh's size. */
export const movement: Measure = {
  name: 'movement',
  label: 'Movement',
  suits: ({ positions }) => positions !== null,
  of: (measured) => {
    const values = distances(measured);
    const end = Number(Math.max(0.1, quantile(values, 0.99)).toPrecision(2));
    return {
      title: 'How far it moved',
      summary: `on average ${mean(values).toPrecision(3)} %`,
      scale: { kind: 'rising', end, unit: ' % of its size' },
      values,
    };
  },
};

function distances(measured: Measured): Float32Array<ArrayBuffer> {
  const before = measured.mesh.positions;
  const now = positionsNow(measured);
  const perSize = 100 / (surveyOf(measured.mesh).diagonal || 1);
  const values = new Float32Array(before.length / 3);
  for (let p = 0, i = 0; p < values.length; p++, i += 3)
    values[p] =
      perSize * Math.hypot(now[i]! - before[i]!, now[i + 1]! - before[i + 1]!, now[i + 2]! - before[i + 2]!);
  return values;
}
