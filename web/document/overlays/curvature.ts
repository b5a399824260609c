import { shownPositions, type WhittleDocument } from '../document.ts';
import type { Measure } from './overlay.ts';
import { percent, quantile, roundedUp } from './statistics.ts';
import { surveyOf } from './survey.ts';

/** Less curved than this is nearly flat; 1 is a ball whose surface is as large as the mesh's. */
const nearlyFlat = 0.5;

/** Of the file's own shape; negative at saddles, positive at peaks and hollows, zero where it can be unrolled (2021, Fig. 21). */
export const curvatureBefore: Measure = {
  name: 'curvature-before',
  label: 'Curvature before',
  suits: () => true,
  of: (document) => {
    const before = curvatureOf(document, document.mesh.positions);
    const flat = percent(flatShare(before));
    return {
      ...picture(document, before, before),
      title: 'Gaussian curvature, before',
      summary: `${flat} nearly flat`,
      verdict: `Nearly flat, under half of a ball’s: ${flat} of the vertices.`,
    };
  },
};

export const curvatureAfter: Measure = {
  name: 'curvature-after',
  label: 'Curvature after',
  before: 'curvature-before',
  suits: ({ result }) => result !== null,
  of: (document) => {
    const before = curvatureOf(document, document.mesh.positions);
    const after = curvatureOf(document, shownPositions(document));
    const [was, flat] = [percent(flatShare(before)), percent(flatShare(after))];
    return {
      ...picture(document, after, before),
      title: 'Gaussian curvature, after',
      summary: `${flat} nearly flat`,
      verdict: `Nearly flat, under half of a ball’s: ${was} of the vertices before, ${flat} after.`,
    };
  },
};

/** On one scale for before and after, wide enough for all but the sharpest places of before. */
function picture(document: WhittleDocument, curvature: Float64Array, before: Float64Array) {
  const values = surveyOf(document.mesh).spread(curvature);
  const end = roundedUp(Math.max(nearlyFlat, quantile(before.map(Math.abs), 0.9)));
  const scale = { kind: 'signed', end, unit: ' × a ball’s' } as const;
  return values.some(Number.isNaN) ? { scale, values, blank: 'boundary' } : { scale, values };
}

/** In those of a ball whose surface is as large as the file's shape, #V: the same at any size. */
function curvatureOf({ mesh }: WhittleDocument, positions: Float64Array): Float64Array {
  const survey = surveyOf(mesh);
  const perBall = survey.area / (4 * Math.PI);
  return survey.curvature(positions).map((value) => value * perBall);
}

function flatShare(curvature: Float64Array): number {
  let flat = 0;
  let all = 0;
  for (const value of curvature) {
    if (Math.abs(value) < nearlyFlat) flat++;
    if (!Number.isNaN(value)) all++;
  }
  return all > 0 ? flat / all : 0;
}
