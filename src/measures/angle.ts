import { type GaussLookup, lookup } from '../inputs/styles/gauss-lookup.ts';
import { dot, row } from '../mesh/vectors.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import { type Measure, type Measured, type Overlay, positionsNow } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile } from './statistics.ts';

const hasTargets = ({ targets }: Measured): boolean => targets !== null;

/** Between the normals of the mesh and those of the style (2021, Fig. 15). */
export const angleBefore: Measure = {
  name: 'angle-before',
  label: 'Angle before',
  suits: hasTargets,
  of: (measured) => {
    const before = anglesBefore(measured);
    return overlay('Angle to the style, before', before, before);
  },
};

export const angleAfter: Measure = {
  name: 'angle-after',
  label: 'Angle after',
  before: 'angle-before',
  suits: (measured) => measured.positions !== null && hasTargets(measured),
  of: (measured) => {
    const { map, from } = measured.targets!;
    const survey = surveyOf(measured.mesh);
    const now = survey.normals(positionsNow(measured));
    const asked = from ? survey.normals(from) : now;
    const after = angles(now, targetNormals(map, asked));
    return overlay('Angle to the style, after', after, anglesBefore(measured));
  },
};

/** One scale for both, so that they can be compared. */
function overlay(title: string, values: Float32Array<ArrayBuffer>, before: Float32Array): Overlay {
  const end = Math.max(10, 5 * Math.ceil(quantile(before, 0.98) / 5));
  const summary = `on average ${mean(values).toPrecision(3)}°`;
  return { title, summary, scale: { kind: 'rising', end, unit: '°' }, values };
}

function anglesBefore(measured: Measured): Float32Array<ArrayBuffer> {
  const normals = surveyOf(measured.mesh).normals(measured.mesh.positions);
  return angles(normals, targetNormals(measured.targets!.map, normals));
}

let lastLookup: { readonly map: GaussMap; readonly target: GaussLookup } | null = null;
/** What was looked up for some normals; those of a file are asked for again at every step of a slider. */
const lookedUp = new WeakMap<Float32Array, { readonly map: GaussMap; readonly targets: Float32Array }>();

/** @param normals #P×3 */
function targetNormals(map: GaussMap, normals: Float32Array): Float32Array {
  const known = lookedUp.get(normals);
  if (known?.map === map) return known.targets;
  if (lastLookup?.map !== map) lastLookup = { map, target: lookup(map) };
  const { target } = lastLookup;
  const targets = new Float32Array(normals.length);
  for (let p = 0; 3 * p < normals.length; p++) targets.set(target(row(normals, p)), 3 * p);
  lookedUp.set(normals, { map, targets });
  return targets;
}

/** In degrees, between rows. */
function angles(a: Float32Array, b: Float32Array): Float32Array<ArrayBuffer> {
  const values = new Float32Array(a.length / 3);
  for (let p = 0; p < values.length; p++) {
    const cosine = Math.max(-1, Math.min(1, dot(row(a, p), row(b, p))));
    values[p] = (Math.acos(cosine) * 180) / Math.PI;
  }
  return values;
}
