import type { Mesh } from '../../mesh/mesh.ts';
import type { Vec3 } from '../../mesh/vectors.ts';
import { convexHull } from './convex-hull.ts';
import { normalsOfConvex } from './convex-normals.ts';
import * as solids from './solids.ts';
import { meshOf } from './surface.ts';

/** A convex style with few face directions: normals snap to the closest of them (2021, §3.1). */
export interface Primitive {
  /** In kebab-case; the name in recipes and on the command line. */
  readonly id: string;
  readonly name: string;
  /** Closed, outside out; for pictures. */
  readonly mesh: Mesh;
  /** #N×3, unit, distinct, the direction of the largest area first. */
  readonly normals: Float64Array<ArrayBuffer>;
}

/** Sides by which the round ones are sampled: no normal is further than 1.4° from one of theirs. */
export const roundSides = 128;

const corners: readonly (readonly [id: string, name: string, corners: () => readonly Vec3[]])[] = [
  ['cube', 'Cube', () => solids.cube],
  ['bevelled-cube', 'Bevelled cube', () => solids.bevelledCube(0.3)],
  ['tetrahedron', 'Tetrahedron', () => solids.tetrahedron],
  ['octahedron', 'Octahedron', () => solids.octahedron],
  ['dodecahedron', 'Dodecahedron', () => solids.dodecahedron],
  ['icosahedron', 'Icosahedron', () => solids.icosahedron],
  ['truncated-octahedron', 'Truncated octahedron', () => solids.truncated(solids.octahedron, 1 / 3)],
  ['truncated-icosahedron', 'Truncated icosahedron', () => solids.truncated(solids.icosahedron, 1 / 3)],
  ['triangular-prism', 'Triangular prism', () => solids.prism(3, 2)],
  ['pentagonal-prism', 'Pentagonal prism', () => solids.prism(5, 2)],
  ['hexagonal-prism', 'Hexagonal prism', () => solids.prism(6, 2)],
  ['octagonal-prism', 'Octagonal prism', () => solids.prism(8, 2)],
  ['hexagonal-bipyramid', 'Hexagonal bipyramid', () => solids.bipyramid(6, 2.4)],
  // Four equilateral sides.
  ['square-pyramid', 'Square pyramid', () => solids.pyramid(4, 1)],
  ['cone', 'Cone', () => solids.pyramid(roundSides, 2)],
  ['cylinder', 'Cylinder', () => solids.prism(roundSides, 2)],
];

/** Other names of a primitive: solids that have its face directions, so that as styles they are the same. */
const sameNormals: Readonly<Record<string, string>> = {
  'truncated-tetrahedron': 'octahedron',
  'truncated-cube': 'truncated-octahedron',
};

/** The names of primitives, in the order of a gallery; no two of them have the same normals. */
export const primitiveIds: readonly string[] = corners.map(([id]) => id);

const made = new Map<string, Primitive>();

/** The primitive of that name, or with the normals of that solid, made at the first asking; undefined if there is none. */
export function findPrimitive(name: string): Primitive | undefined {
  const id = Object.hasOwn(sameNormals, name) ? sameNormals[name]! : name;
  const line = corners.find((candidate) => candidate[0] === id);
  if (!line) return undefined;
  if (!made.has(id)) {
    const points = line[2]();
    const mesh = meshOf(points, convexHull(points));
    made.set(id, { id, name: line[1], mesh, normals: normalsOfConvex(mesh) });
  }
  return made.get(id);
}
