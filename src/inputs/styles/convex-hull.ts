import { WhittleError } from '../../mesh/failure.ts';
import { cross, distance, dot, doubledAreaVector, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';
import type { Triangle } from './surface.ts';

/** Points nearer to a plane than this share of the extent lie in it. */
const coplanar = 1e-10;

interface Facet {
  readonly corners: Triangle;
  /** Outward. */
  readonly normal: Vec3;
  readonly height: number;
}

/**
 * The convex hull of some points as triangles, counter-clockwise from outside; flat facets of more corners are split. The
 * points are added one by one: those facets that see the new point give way to a cone from their horizon to it. Made
 * for up to some thousand points (time grows with points times facets).
 *
 * @returns indices into `points`; points inside, or inside a facet or an edge, are not used
 * @throws WhittleError `unsuitable-mesh` if all points lie in a plane
 */
export function convexHull(points: readonly Vec3[]): Triangle[] {
  const start = startingTetrahedron(points);
  const tolerance = coplanar * extent(points);
  const inside = start
    .map((index) => points[index]!)
    .reduce((sum, p) => [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]]);
  const center: Vec3 = [inside[0] / 4, inside[1] / 4, inside[2] / 4];
  const [a, b, c, d] = start;
  let facets = [[a, b, c] as const, [a, c, d] as const, [a, d, b] as const, [b, d, c] as const].map(
    (corners) => outward(points, corners, center),
  );
  points.forEach((point, index) => {
    if (start.includes(index)) return;
    const sees = (facet: Facet): boolean => dot(facet.normal, point) - facet.height > tolerance;
    const visible = facets.filter(sees);
    if (visible.length === 0) return;
    const cone = horizon(visible).map(([from, to]) => facetOf(points, [from, to, index]));
    facets = [...facets.filter((facet) => !sees(facet)), ...cone];
  });
  return facets.map(({ corners }) => corners);
}

function facetOf(points: readonly Vec3[], corners: Triangle): Facet {
  const [a, b, c] = corners.map((corner) => points[corner]!) as [Vec3, Vec3, Vec3];
  const normal = unit(doubledAreaVector(a, b, c));
  return { corners, normal, height: dot(normal, a) };
}

/** The facet with the side away from `center` outside. */
function outward(points: readonly Vec3[], [a, b, c]: Triangle, center: Vec3): Facet {
  const facet = facetOf(points, [a, b, c]);
  return dot(facet.normal, center) < facet.height ? facet : facetOf(points, [a, c, b]);
}

/** Edges of the visible facets whose other side is hidden, as the visible side passes them. */
function horizon(visible: readonly Facet[]): [number, number][] {
  const edges = visible.flatMap(({ corners: [a, b, c] }): [number, number][] => [
    [a, b],
    [b, c],
    [c, a],
  ]);
  const passed = new Set(edges.map(([from, to]) => `${from} ${to}`));
  return edges.filter(([from, to]) => !passed.has(`${to} ${from}`));
}

/** Four points far apart, in no plane. */
function startingTetrahedron(points: readonly Vec3[]): [number, number, number, number] {
  const farthest = (measure: (point: Vec3) => number): number => {
    let best = 0;
    points.forEach((point, index) => {
      if (measure(point) > measure(points[best]!)) best = index;
    });
    return best;
  };
  const flat = (): never => {
    throw new WhittleError(
      'unsuitable-mesh',
      'All points lie in one plane, so there is no solid to speak of.',
    );
  };
  if (points.length < 4) return flat();
  const least = coplanar * extent(points);
  const a = 0;
  const b = farthest((p) => distance(p, points[a]!));
  const axis = unit(subtract(points[b]!, points[a]!));
  const fromAxis = (p: Vec3): number => Math.hypot(...cross(axis, subtract(p, points[a]!)));
  const c = farthest(fromAxis);
  if (fromAxis(points[c]!) <= least) return flat();
  const normal = unit(doubledAreaVector(points[a]!, points[b]!, points[c]!));
  const fromPlane = (p: Vec3): number => Math.abs(dot(normal, subtract(p, points[a]!)));
  const d = farthest(fromPlane);
  if (fromPlane(points[d]!) <= least) return flat();
  return [a, b, c, d];
}

/** Largest distance from the first point. */
function extent(points: readonly Vec3[]): number {
  return points.reduce((largest, point) => Math.max(largest, distance(point, points[0]!)), 0);
}
