import { weld } from '../../src/mesh/weld.ts';
import type { GaussMap } from '../../src/methods/gauss-map.ts';
import { type GaussLookup, lookup } from '../../src/styles/gauss-lookup.ts';
import { findPrimitive } from '../../src/styles/primitives.ts';
import { dot, row } from '../../src/styles/vectors.ts';
import { NormalWriter } from '../../src/viewer/normals.ts';
import { shownPositions, type WhittleDocument } from './document.ts';
import { styleOf } from './offered-methods.ts';
import type { OverlayName } from './store.ts';

/** A number for every position of the mesh, to be shown as colours. */
export interface Overlay {
  readonly name: OverlayName;
  readonly title: string;
  readonly unit: string;
  /** Where the colours end; they begin at 0. */
  readonly max: number;
  readonly mean: number;
  /** #P */
  readonly values: Float32Array<ArrayBuffer>;
}

export const overlayTitles: Readonly<Record<OverlayName, string>> = {
  none: 'Clay',
  before: 'Angle to the style, before',
  after: 'Angle to the style, after',
  moved: 'How far it moved',
};

/** Measures a document; null where there is nothing to measure (no result yet, no style). */
export function measure(document: WhittleDocument, name: OverlayName): Overlay | null {
  if (name === 'none') return null;
  if (name === 'moved') return document.result ? moved(document) : null;
  const map = targetsOf(document);
  if (!map) return null;
  const { positions } = document.mesh;
  const before = angles(normalsOf(document, positions), targetNormals(document, positions, lookup(map)));
  const shown = shownPositions(document);
  const from = targetsFollow(document) ? shown : positions;
  const values =
    name === 'before'
      ? before
      : angles(normalsOf(document, shown), targetNormals(document, from, lookup(map)));
  // One scale for both, so that they can be compared.
  const max = Math.max(10, 5 * Math.ceil(quantile(before, 0.98) / 5));
  return { name, title: overlayTitles[name], unit: '°', max, mean: mean(values), values };
}

/** What the document's method draws normals to. The cubic method carves without a Gauss map, but its solid has one. */
function targetsOf(document: WhittleDocument): GaussMap | null {
  const { method, parameters } = document;
  if (method === 'cubic') {
    const solid = findPrimitive(String(parameters.polyhedron ?? 'cube'));
    return solid ? { kind: 'closest', normals: solid.normals } : null;
  }
  return styleOf(document)?.map ?? null;
}

/** Whether targets are those of the output's normals, not of the input's. */
function targetsFollow({ method, parameters }: WhittleDocument): boolean {
  return method === 'polycube' || parameters.dynamicTargets === true;
}

function moved(document: WhittleDocument): Overlay {
  const { mesh, report } = document;
  const { min, max } = report;
  const size = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]) || 1;
  const now = shownPositions(document);
  const values = new Float32Array(mesh.positions.length / 3);
  for (let p = 0; p < values.length; p++) {
    const off = [0, 1, 2].map((axis) => now[3 * p + axis]! - mesh.positions[3 * p + axis]!);
    values[p] = (100 * Math.hypot(...off)) / size;
  }
  const most = Math.max(0.1, quantile(values, 0.99));
  return {
    name: 'moved',
    title: overlayTitles.moved,
    unit: ' % of its size',
    max: Number(most.toPrecision(2)),
    mean: mean(values),
    values,
  };
}

const writers = new WeakMap<object, NormalWriter>();

function normalsOf({ mesh }: WhittleDocument, positions: Float64Array): Float32Array {
  const normals = new Float32Array(positions.length);
  let writer = writers.get(mesh);
  if (!writer) {
    const welded = weld(mesh.positions, mesh.triangles);
    writer = new NormalWriter(
      mesh.triangles,
      welded.triangles,
      welded.vertexOfPosition,
      welded.positions.length / 3,
    );
    writers.set(mesh, writer);
  }
  // Single precision needs the origin near.
  const [x, y, z] = row(mesh.positions, 0);
  const near = Float32Array.from(positions, (value, at) => value - (at % 3 === 0 ? x : at % 3 === 1 ? y : z));
  writer.write(near, normals);
  return normals;
}

function targetNormals(
  document: WhittleDocument,
  positions: Float64Array,
  target: GaussLookup,
): Float32Array {
  const normals = normalsOf(document, positions);
  const targets = new Float32Array(normals.length);
  for (let p = 0; 3 * p < normals.length; p++) targets.set(target(row(normals, p)), 3 * p);
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

function mean(values: Float32Array): number {
  return values.length > 0 ? values.reduce((sum, value) => sum + value, 0) / values.length : 0;
}

function quantile(values: Float32Array, share: number): number {
  const sorted = values.slice().sort();
  return sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
}
