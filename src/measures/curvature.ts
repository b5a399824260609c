import { type Measure, type Measured, positionsNow } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { percent, quantile, roundedUp } from './statistics.ts';

/**
 * Gaussian curvature of the file's own shape: negative at saddles, positive at peaks and hollows, zero where it can be unrolled
 * (2021, Fig. 21).
 */
export const curvatureBefore: Measure = {
  name: 'curvature-before',
  label: 'Curvature before',
  suits: () => true,
  of: (measured) => {
    const before = curvatureOf(measured, measured.mesh.positions);
    const { limit, ...picture } = pictureOf(measured, before, before);
    const flat = percent(flatShare(before, limit));
    return {
      ...picture,
      title: 'Gaussian curvature, before',
      summary: `${flat} nearly flat`,
      verdict: `Nearly flat, under ${limit} × a ball’s: ${flat} of the vertices.`,
    };
  },
};

export const curvatureAfter: Measure = {
  name: 'curvature-after',
  label: 'Curvature after',
  before: 'curvature-before',
  suits: ({ positions }) => positions !== null,
  of: (measured) => {
    const before = curvatureOf(measured, measured.mesh.positions);
    const after = curvatureOf(measured, positionsNow(measured));
    const { limit, ...picture } = pictureOf(measured, after, before);
    const [was, flat] = [before, after].map((curvature) => percent(flatShare(curvature, limit)));
    return {
      ...picture,
      title: 'Gaussian curvature, after',
      summary: `${flat} nearly flat`,
      verdict: `Nearly flat, under ${limit} × a ball’s: ${was} of the vertices before, ${flat} after.`,
    };
  },
};

/**
 * On one scale for before and after, wide enough for all but the sharpest places of before. What is below the `limit` is nearly
 * flat: a tenth of that scale, for no scan is smoother, or what nobody would call round.
 */
function pictureOf({ mesh }: Measured, curvature: Float64Array, before: Float64Array) {
  const values = surveyOf(mesh).spread(curvature);
  const end = roundedUp(Math.max(0.5, quantile(before.map(Math.abs), 0.9)));
  const scale = { kind: 'signed', end, unit: ' × a ball’s' } as const;
  const limit = Math.max(0.2, Number((end / 10).toPrecision(2)));
  return values.some(Number.isNaN) ? { scale, values, limit, blank: 'boundary' } : { scale, values, limit };
}

/** In those of a ball whose surface is as large as the file's shape, #V: the same at any size. */
function curvatureOf({ mesh }: Measured, positions: Float64Array): Float64Array {
  const survey = surveyOf(mesh);
  const perBall = survey.area / (4 * Math.PI);
  return survey.curvature(positions).map((value) => value * perBall);
}

function flatShare(curvature: Float64Array, limit: number): number {
  let flat = 0;
  let all = 0;
  for (const value of curvature) {
    if (Math.abs(value) < limit) flat++;
    if (!Number.isNaN(value)) all++;
  }
  return all > 0 ? flat / all : 0;
}
