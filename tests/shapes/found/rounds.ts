import { cross, dot, row, subtract, unit, type Vec3 } from '../../../src/mesh/vectors.ts';
import { fittedRound } from '../fits.ts';
import type { Round } from '../shape.ts';
import type { Pair, SurfaceFacts } from '../surface-facts.ts';
import { type Facet, facetsOf } from './facets.ts';

/** Facets that may follow each other around a cylinder bend by between these, in degrees. */
const bends = { least: 1.5, most: 35 } as const;

/**
 * Finds the cylinders of a surface that nobody has named: facets that follow each other around an axis, each bent from the
 * one before by about as much, five of them and a quarter of a turn at least.
 *
 * Concave ones are holes where they go all the way around and else hollows, convex ones rods and rounded edges.
 */
export function roundsOf(facts: SurfaceFacts): Round[] {
  const facets = facetsOf(facts);
  const taken = new Set<number>();
  const counts = new Map<string, number>();
  const found: Round[] = [];
  for (const [facet, { sides }] of facets.entries())
    for (const { beyond, pair } of sides) {
      if (taken.has(facet) || taken.has(beyond) || !isBend(pair)) continue;
      const band = bandFrom(facts, facets, facet, pair, taken);
      const kind = kindOf(facts, facets, band);
      if (!kind) continue;
      for (const member of band.facets) taken.add(member);
      const number = (counts.get(kind) ?? 0) + 1;
      counts.set(kind, number);
      found.push({ name: `${kind} ${number}`, vertices: verticesOf(facts, facets, band), axis: band.axis });
    }
  return found;
}

/** Facets around an axis. */
interface Band {
  readonly facets: ReadonlySet<number>;
  readonly axis: Vec3;
  readonly isConvex: boolean;
  /** Degrees from each facet to the next. */
  readonly bend: number;
}

const isBend = ({ angle }: Pair): boolean => angle > bends.least && angle < bends.most;

function bandFrom(
  facts: SurfaceFacts,
  facets: readonly Facet[],
  from: number,
  first: Pair,
  taken: ReadonlySet<number>,
): Band {
  const { normals } = facts;
  const axis = unit(cross(normals[first.faces[0]]!, normals[first.faces[1]]!));
  const isConvex = bendsOut(facts, first);
  const members = new Set([from]);
  const queue = [from];
  for (let facet = queue.pop(); facet !== undefined; facet = queue.pop())
    for (const { beyond, pair } of facets[facet]!.sides) {
      if (members.has(beyond) || taken.has(beyond) || !isBend(pair)) continue;
      const isAlike = pair.angle < 1.6 * first.angle && first.angle < 1.6 * pair.angle;
      const isAround = Math.abs(dot(normals[pair.faces[1]]!, axis)) < 0.02;
      if (!isAlike || !isAround || bendsOut(facts, pair) !== isConvex) continue;
      members.add(beyond);
      queue.push(beyond);
    }
  return { facets: members, axis, isConvex, bend: first.angle };
}

/** Whether the second face of a pair lies behind the first. */
function bendsOut({ mesh, normals }: SurfaceFacts, { faces, edge, opposite }: Pair): boolean {
  const across = subtract(row(mesh.positions, opposite[1]), row(mesh.positions, edge[0]));
  return dot(normals[faces[0]]!, across) < 0;
}

/** What a person calls it; undefined where it is no cylinder. */
function kindOf(facts: SurfaceFacts, facets: readonly Facet[], band: Band): string | undefined {
  const turn = band.bend * band.facets.size;
  if (band.facets.size < 5 || turn < 90) return undefined;
  const { roundness } = fittedRound(facts.mesh.positions, verticesOf(facts, facets, band), band.axis);
  if (!(roundness < 0.004)) return undefined;
  const isWhole = turn > 330;
  if (band.isConvex) return isWhole ? 'rod' : 'rounded edge';
  return isWhole ? 'hole' : 'hollow';
}

function verticesOf({ mesh }: SurfaceFacts, facets: readonly Facet[], band: Band): number[] {
  const corners = [...band.facets].flatMap((facet) =>
    facets[facet]!.faces.flatMap((face) => [...mesh.triangles.subarray(3 * face, 3 * face + 3)]),
  );
  return [...new Set(corners)];
}
