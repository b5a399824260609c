import { captureIds, findCapture } from '../../src/inputs/styles/capture-gallery.ts';
import { findPrimitive, primitiveIds } from '../../src/inputs/styles/primitives.ts';
import { findStyleMesh, styleMeshIds } from '../../src/inputs/styles/style-meshes.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import type { Asset } from '../../src/recipe/index.ts';

export type StyleGroup = 'shapes' | 'meshes' | 'captures';

/** A style that can be clicked. */
export interface StyleEntry {
  /** Unique on the page. */
  readonly id: string;
  readonly name: string;
  /** As recipes and the command line call it. */
  readonly source: string;
  readonly group: StyleGroup;
  /** What the person brought; absent for the styles that come with the page. */
  readonly asset?: Asset;
  /** A convex shape or a style mesh, or the normals themselves. Made when first asked for. */
  readonly subject: () => { readonly mesh: Mesh } | { readonly map: GaussMap };
}

export const groups: readonly { readonly id: StyleGroup; readonly title: string; readonly about: string }[] =
  [
    { id: 'shapes', title: 'Shapes', about: 'Every normal goes to the nearest face' },
    { id: 'meshes', title: 'Style meshes', about: 'Read through the sphere' },
    { id: 'captures', title: 'Captures', about: 'Balls that hold normals' },
  ];

/** The styles that come with the page. */
export const builtIn: readonly StyleEntry[] = [
  ...primitiveIds.map((id) => entry('shapes', id, () => ({ mesh: findPrimitive(id)!.mesh }))),
  ...styleMeshIds.map((id) => entry('meshes', id, () => ({ mesh: findStyleMesh(id)!.mesh }))),
  ...captureIds.map((id) => entry('captures', id, () => ({ map: findCapture(id)!.map }))),
];

/** The style that the page opens a method with, by its parameter: the one that looks best at once. */
export const firstStyles: Readonly<Record<string, string>> = { style: 'octahedron', directions: 'cube' };

/** What recipes call a painted ball, and the name that it is saved under; a number is put to it if several steps have one. */
export const paintedName = 'painted.png';

export function isPainted(name: string): boolean {
  return /^painted(-\d+)?\.png$/.test(name);
}

/** What a style can be made of. */
export type StyleAsset = Extract<Asset, { kind: 'mesh' | 'gauss-map' }>;

let brought = 0;

/** A style of the person's own. @param source its name in recipes, unlike all others */
export function ownStyle(group: StyleGroup, source: string, asset: StyleAsset): StyleEntry {
  const name = source.replace(/\.[^.]*$/, '') || source;
  const subject = () => (asset.kind === 'mesh' ? { mesh: asset.mesh } : { map: asset.map });
  return { id: `own-${++brought}`, name, source, group, asset, subject };
}

function entry(group: StyleGroup, id: string, subject: StyleEntry['subject']): StyleEntry {
  const name = id.charAt(0).toUpperCase() + id.slice(1).replaceAll('-', ' ');
  return { id: `${group}-${id}`, name, source: id, group, subject };
}
