import type { Mesh } from '../../mesh/mesh.ts';
import { jessen } from './jessen.ts';
import { oloid } from './oloid.ts';
import { type ProfilePoint, revolved } from './revolution.ts';
import { twistedCube } from './twisted-cube.ts';

/** A closed style of genus 0, smooth or concave: its normals reach the sphere by the flow `spherical` (2021, §3.1). */
export interface StyleMesh {
  /** In kebab-case; the name in recipes and on the command line. */
  readonly id: string;
  readonly name: string;
  /** Two to six thousand vertices of about equal spacing, outside out. */
  readonly mesh: Mesh;
}

/** A curve of a profile, from its parameter 0 to 1. */
const curve = (point: (s: number) => ProfilePoint): ProfilePoint[] =>
  Array.from({ length: 1001 }, (_, k) => point(k / 1000));

/**
 * The tractricoid, a surface of constant negative curvature: two horns on a sharp rim, cut where their radius is `tip` of
 * the rim's and closed with a disc.
 */
export function tractricoid(edge: number, tip = 0.12): Mesh {
  const last = Math.acosh(1 / tip);
  const horn = (u: number): ProfilePoint => [1 / Math.cosh(u), u - Math.tanh(u)];
  const top: ProfilePoint = [0, horn(last)[1]];
  const down = ([radius, y]: ProfilePoint): ProfilePoint => [radius, -y];
  const rising = curve((s) => horn(last * s));
  const disc = [rising.at(-1)!, top];
  return revolved([disc.map(down).reverse(), rising.map(down).reverse(), rising, disc], edge);
}

/** A cylinder of radius 1 with half spheres for ends; its straight part is `straight` long. */
export function capsule(edge: number, straight = 2): Mesh {
  const half = curve((s): ProfilePoint => {
    return s === 1
      ? [0, straight / 2 + 1]
      : [Math.cos((Math.PI / 2) * s), straight / 2 + Math.sin((Math.PI / 2) * s)];
  });
  const down = half.map(([radius, y]): ProfilePoint => [radius, -y]).reverse();
  return revolved([down, [down.at(-1)!, half[0]!], half], edge);
}

/** Two caps of a sphere on a sharp rim; `thickness` is that of the middle, the rim's radius is 1. */
export function lens(edge: number, thickness = 0.8): Mesh {
  const height = thickness / 2;
  const radius = (1 + height * height) / (2 * height);
  const angle = Math.asin(1 / radius);
  const upper = curve((s): ProfilePoint => {
    if (s === 0) return [1, 0];
    return s === 1
      ? [0, height]
      : [radius * Math.sin(angle * (1 - s)), radius * Math.cos(angle * (1 - s)) - radius + height];
  });
  return revolved([upper.map(([r, y]): ProfilePoint => [r, -y]).reverse(), upper], edge);
}

const makers: readonly (readonly [id: string, name: string, make: () => Mesh])[] = [
  ['oloid', 'Oloid', () => oloid(28)],
  ['jessen', 'Jessen’s icosahedron', () => jessen(20)],
  ['tractricoid', 'Tractricoid', () => tractricoid(0.06)],
  ['capsule', 'Capsule', () => capsule(0.09)],
  ['lens', 'Lens', () => lens(0.055)],
  ['twisted-cube', 'Twisted cube', () => twistedCube(24, Math.PI / 2)],
];

/** The names by which a style mesh can be asked for, in the order of a gallery. */
export const styleMeshIds: readonly string[] = makers.map(([id]) => id);

const made = new Map<string, StyleMesh>();

/** The style mesh of that name, made at the first asking; undefined if there is none. */
export function findStyleMesh(id: string): StyleMesh | undefined {
  const line = makers.find((candidate) => candidate[0] === id);
  if (!line) return undefined;
  if (!made.has(id)) made.set(id, { id, name: line[1], mesh: line[2]() });
  return made.get(id);
}
