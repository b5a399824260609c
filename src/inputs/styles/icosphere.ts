import { add, row, unit, type Vec3 } from '../../mesh/vectors.ts';
import { convexHull } from './convex-hull.ts';
import { icosahedron } from './solids.ts';

/** A triangulated unit sphere. */
export interface Icosphere {
  /** #V×3, unit. */
  readonly points: Float64Array<ArrayBuffer>;
  /** #F×3, counter-clockwise from outside. */
  readonly triangles: Uint32Array<ArrayBuffer>;
}

const made: Icosphere[] = [];

/**
 * The icosahedron with every edge halved some times and pushed out to the unit sphere: 10·4ⁿ + 2 points. It is its own mirror
 * image in each of the coordinate planes. Made once; do not write to it.
 */
export function icosphere(halvings: number): Icosphere {
  for (let level = made.length; level <= halvings; level++) {
    made[level] = level === 0 ? start() : halved(made[level - 1]!);
  }
  return made[halvings]!;
}

function start(): Icosphere {
  return {
    points: Float64Array.from(icosahedron.flatMap(unit)),
    triangles: Uint32Array.from(convexHull(icosahedron).flat()),
  };
}

/** Every triangle becomes four. */
function halved({ points, triangles }: Icosphere): Icosphere {
  const count = points.length / 3;
  const finer = new Float64Array(points.length + (3 * triangles.length) / 2);
  finer.set(points);
  const middles = new Map<number, number>();
  const middle = (a: number, b: number): number => {
    const key = Math.min(a, b) * count + Math.max(a, b);
    const known = middles.get(key);
    if (known !== undefined) return known;
    const vertex = count + middles.size;
    finer.set(unit(add(row(points, a), row(points, b)) as Vec3), 3 * vertex);
    middles.set(key, vertex);
    return vertex;
  };
  const faces = new Uint32Array(4 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = [triangles[corner]!, triangles[corner + 1]!, triangles[corner + 2]!];
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    faces.set([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 4 * corner);
  }
  return { points: finer, triangles: faces };
}
