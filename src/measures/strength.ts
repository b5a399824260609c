import type { WhittleDocument } from '../editor/project.ts';
import type { Measure } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile, roundedUp } from './statistics.ts';

/** λ of every vertex, where the parameters hold one for each; places that the file stores twice get the mean, as in the solver. */
export const strength: Measure = {
  name: 'strength',
  label: 'Strength',
  suits: (document) => strengthsOf(document) !== null,
  of: (document) => {
    const given = strengthsOf(document)!;
    const survey = surveyOf(document.mesh);
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

/** One number for each position of the file; null where there is only the one λ. */
function strengthsOf({ mesh, parameters }: WhittleDocument): ArrayLike<number> | null {
  const { lambdaPerVertex: given } = parameters;
  const isList = Array.isArray(given) || given instanceof Float64Array;
  return isList && given.length === mesh.positions.length / 3 ? given : null;
}
