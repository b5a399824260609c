import { styleOf, styleParameter } from '../../web/app/offered-methods.ts';
import { shownPositions, type WhittleDocument } from '../editor/project.ts';
import { type GaussLookup, lookup } from '../inputs/styles/gauss-lookup.ts';
import { findPrimitive, type Primitive } from '../inputs/styles/primitives.ts';
import { dot, row } from '../mesh/vectors.ts';
import { findMethod } from '../methods/registry.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { Measure, Overlay } from './measure.ts';
import { surveyOf } from './mesh-survey.ts';
import { mean, quantile } from './statistics.ts';

/** What a document's method draws normals to. */
interface Targets {
  readonly map: GaussMap;
  /** Looked up from the normals that there are, and not once from those of the file. */
  readonly follow: boolean;
}

/** What the method's descriptor names: a style that was chosen, or by its name a solid of ours. */
function targetsOf(document: WhittleDocument): Targets | null {
  const { parameters } = document;
  const method = findMethod(document.method);
  const targets = method?.targets?.(parameters);
  if (!targets) return null;
  const solid = findPrimitive(String(parameters[targets.style] ?? 'cube'));
  const map = styleParameter(method) ? styleOf(document)?.map : solid && mapOf(solid);
  return map ? { map, follow: targets.lookedUpFrom === 'output' } : null;
}

const maps = new WeakMap<Primitive, GaussMap>();

/** The same object at every asking. */
function mapOf(solid: Primitive): GaussMap {
  const map = maps.get(solid) ?? { kind: 'closest', normals: solid.normals };
  maps.set(solid, map);
  return map;
}

const hasTargets = (document: WhittleDocument): boolean => targetsOf(document) !== null;

/** Between the normals of the mesh and those of the style (2021, Fig. 15). */
export const angleBefore: Measure = {
  name: 'angle-before',
  label: 'Angle before',
  suits: hasTargets,
  of: (document) => {
    const before = anglesBefore(document);
    return overlay('Angle to the style, before', before, before);
  },
};

export const angleAfter: Measure = {
  name: 'angle-after',
  label: 'Angle after',
  before: 'angle-before',
  suits: (document) => document.result !== null && hasTargets(document),
  of: (document) => {
    const targets = targetsOf(document)!;
    const survey = surveyOf(document.mesh);
    const now = survey.normals(shownPositions(document));
    const asked = targets.follow ? now : survey.normals(document.mesh.positions);
    const after = angles(now, targetNormals(targets.map, asked));
    return overlay('Angle to the style, after', after, anglesBefore(document));
  },
};

/** One scale for both, so that they can be compared. */
function overlay(title: string, values: Float32Array<ArrayBuffer>, before: Float32Array): Overlay {
  const end = Math.max(10, 5 * Math.ceil(quantile(before, 0.98) / 5));
  const summary = `on average ${mean(values).toPrecision(3)}°`;
  return { title, summary, scale: { kind: 'rising', end, unit: '°' }, values };
}

function anglesBefore(document: WhittleDocument): Float32Array<ArrayBuffer> {
  const normals = surveyOf(document.mesh).normals(document.mesh.positions);
  return angles(normals, targetNormals(targetsOf(document)!.map, normals));
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
