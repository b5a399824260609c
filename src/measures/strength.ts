import type { Measure } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile, roundedUp } from './statistics.ts';

/** λ of every vertex, where the parameters hold one for each; places that the file stores twice get the mean, as in the solver. */
export const strength: Measure = {
  name: 'strength',
  label: 'Strength',
  suits: ({ strengths }) => strengths !== null,
  of: (measured) => {
    const given = measured.strengths!;
    const survey = surveyOf(measured.mesh);
    const sums = new Float64Array(given.length);
    const counts = new Float64Array(given.length);
    survey.vertexOfPosition.forEach((vertex, p) => {
      sums[vertex] += given[p]!;
      counts[vertex] += 1;
    });
    const values = survey.spread(sums.map((sum, vertex) => sum / counts[vertex]!));
    return {
      title: 'Strength by vertex',
      summary: `on average ${Number(mean(values).toPrecision(3))}`,
      scale: { kind: 'rising', end: roundedUp(Math.max(0.01, quantile(values, 1))), unit: '' },
      values,
    };
  },
};
