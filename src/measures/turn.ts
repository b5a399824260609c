import { dot, row } from '../mesh/vectors.ts';
import { type Measure, type Measured, positionsNow } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile } from './statistics.ts';

/** The angle between where the surface looks now and where it looked in the file: what tilts, bends or dents shows. */
export const turn: Measure = {
  name: 'turn',
  label: 'Tilt',
  suits: ({ positions }) => positions !== null,
  of: (measured) => {
    const values = turns(measured);
    const most = quantile(values, 1);
    return {
      title: 'How far the surface tilted',
      summary: `on average ${mean(values).toPrecision(3)}°, ${most.toPrecision(3)}° at most`,
      scale: { kind: 'rising', end: ends.find((end) => end >= most) ?? ends.at(-1)!, unit: '°' },
      values,
    };
  },
};

/** Where the band may end, in degrees. */
const ends = [1, 2, 5, 10, 20, 45, 90];

/** In degrees, #P. */
function turns(measured: Measured): Float32Array<ArrayBuffer> {
  const survey = surveyOf(measured.mesh);
  const before = survey.normals(measured.mesh.positions);
  const now = survey.normals(positionsNow(measured));
  const values = new Float32Array(before.length / 3);
  for (let p = 0; p < values.length; p++) {
    const cosine = dot(row(before, p), row(now, p));
    values[p] = (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
  }
  return values;
}
