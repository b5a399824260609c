import { add, dot, length, row, scale, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';
import { type SphereMap, sphereMap } from './captures.ts';
import { icosphere } from './icosphere.ts';
import { icosahedron } from './solids.ts';

/** A style made of nothing but a rule for normals. */
export interface Capture {
  /** In kebab-case; the name in recipes and on the command line. */
  readonly id: string;
  readonly name: string;
  readonly map: SphereMap;
}

type Rule = (normal: Vec3) => Vec3;

/** By latitude and longitude about the upward axis. */
const turned =
  (change: (latitude: number, longitude: number) => readonly [number, number]): Rule =>
  ([x, y, z]) => {
    const [latitude, longitude] = change(Math.asin(Math.max(-1, Math.min(1, y))), Math.atan2(x, z));
    const level = Math.cos(latitude);
    return [level * Math.sin(longitude), Math.sin(latitude), level * Math.cos(longitude)];
  };

/** Treads and risers: bands of latitude look up or to the side by turns. */
const terraced = turned((latitude, longitude) => {
  const band = (Math.abs(latitude) / (Math.PI / 2)) * 4;
  const isTread = band % 1 > 0.5;
  return [isTread ? Math.sign(latitude) * (Math.PI / 2) : 0, longitude];
});

const rippled = turned((latitude, longitude) => [latitude + 0.55 * Math.sin(14 * latitude), longitude]);

const fluted = turned((latitude, longitude) => [latitude, longitude + 0.5 * Math.sin(6 * longitude)]);

const snapped =
  (directions: readonly Vec3[]): Rule =>
  (normal) =>
    nearest(directions, normal);

/** A cube with all edges rolled: normals gather at the axes but none is left out. */
const pillowed: Rule = ([x, y, z]) => unit([x ** 3, y ** 3, z ** 3]);

/** Around each of twelve axes a cone: normals lean away from the axis by the same angle. */
const spiky: Rule = (normal) => {
  const axis = nearest(icosahedron.map(unit), normal);
  const away = subtract(normal, scale(axis, dot(normal, axis)));
  if (length(away) < 1e-9) return axis;
  return unit(add(scale(axis, Math.cos(1.05)), scale(unit(away), Math.sin(1.05))));
};

const flattened: Rule = ([x, y, z]) => unit([0.3 * x, y, 0.3 * z]);

/** Waves along x that tilt normals up and down; the poles keep theirs. */
const wavy: Rule = (normal) => {
  const [x, y] = normal;
  return unit(add(normal, [0, 1.2 * Math.cos(6 * x) * (1 - y * y), 0]));
};

const rules: readonly (readonly [id: string, name: string, rule: () => Rule])[] = [
  ['terraced', 'Terraced', () => terraced],
  ['faceted', 'Faceted', () => snapped(rows(icosphere(1).points))],
  ['rippled', 'Rippled', () => rippled],
  ['fluted', 'Fluted', () => fluted],
  ['wavy', 'Wavy', () => wavy],
  ['cubic', 'Cubic', () => snapped(axes)],
  ['pillowed', 'Pillowed', () => pillowed],
  ['spiky', 'Spiky', () => spiky],
  ['flattened', 'Flattened', () => flattened],
];

const axes: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

/** The names by which a capture can be asked for, in the order of a gallery. */
export const captureIds: readonly string[] = rules.map(([id]) => id);

const made = new Map<string, Capture>();

/** The capture of that name, made at the first asking; undefined if there is none. */
export function findCapture(id: string): Capture | undefined {
  const line = rules.find((candidate) => candidate[0] === id);
  if (!line) return undefined;
  if (!made.has(id)) made.set(id, { id, name: line[1], map: sphereMap(line[2]()) });
  return made.get(id);
}

function nearest(directions: readonly Vec3[], normal: Vec3): Vec3 {
  return directions.reduce((best, one) => (dot(one, normal) > dot(best, normal) ? one : best));
}

function rows(points: Float64Array): Vec3[] {
  return Array.from({ length: points.length / 3 }, (_, v) => row(points, v));
}
