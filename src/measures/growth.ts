import { type Measure, type Measured, positionsNow } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { times } from './scale.ts';
import { quantile } from './statistics.ts';

/** Where the band may end. */
const ends = [1.05, 1.1, 1.2, 1.5, 2, 3, 5];

/**
 * The factor by which the surroundings of each place grew: the square root of the areas of the faces around it, after over
 * before. Where angles are kept (ACAP, 2021, Eq. 5) it is the local scale s_k; 1 is the size it had.
 */
export const growth: Measure = {
  name: 'growth',
  label: 'Size',
  suits: ({ positions }) => positions !== null,
  of: (measured) => {
    const factors = growthOf(measured);
    const spread = quantile(
      factors.map((factor) => Math.abs(Math.log(factor))),
      0.95,
    );
    const end = ends.find((candidate) => Math.log(candidate) >= spread) ?? ends.at(-1)!;
    return {
      title: 'How much it grew',
      summary: `mostly ${times(quantile(factors, 0.05))} to ${times(quantile(factors, 0.95))}`,
      scale: { kind: 'factor', end },
      values: surveyOf(measured.mesh).spread(factors),
    };
  },
};

/** #V; NaN where there was no area. */
function growthOf(measured: Measured): Float64Array {
  const survey = surveyOf(measured.mesh);
  const before = survey.ringAreas(measured.mesh.positions);
  const after = survey.ringAreas(positionsNow(measured));
  return after.map((area, v) => (before[v]! > 0 ? Math.sqrt(area / before[v]!) : Number.NaN));
}
