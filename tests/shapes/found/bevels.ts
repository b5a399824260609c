import { distance, dot, row, subtract } from '../../../src/mesh/vectors.ts';
import { extent, principalAxes } from '../fits.ts';
import type { Pair, SurfaceFacts } from '../surface-facts.ts';
import { type Facet, facetsOf } from './facets.ts';

/** What lies at a bevel is bent from it by between these, in degrees; the others are shares of its length and of the diagonal. */
const limits = { least: 25, most: 65, slimness: 0.25, width: 0.05, length: 0.1 } as const;

/**
 * Finds bevels that nobody has named: narrow flat strips between two sides that both fall away from them by about half a
 * right angle. Their vertices by names.
 */
export function bevelsOf(facts: SurfaceFacts): Record<string, number[]> {
  const found = facetsOf(facts).flatMap((facet) => (isBevel(facts, facet) ? [verticesOf(facts, facet)] : []));
  return Object.fromEntries(found.map((vertices, k) => [`bevel ${k + 1}`, vertices]));
}

function isBevel(facts: SurfaceFacts, facet: Facet): boolean {
  const vertices = verticesOf(facts, facet);
  if (vertices.length < 4) return false;
  const { positions } = facts.mesh;
  const { axes } = principalAxes(positions, vertices);
  const [width, long] = [extent(positions, vertices, axes[1]), extent(positions, vertices, axes[2])];
  if (width > limits.slimness * long || width > limits.width * facts.diagonal) return false;
  if (long < limits.length * facts.diagonal) return false;
  const lengthOf = ({ pair }: { pair: Pair }) =>
    distance(row(positions, pair.edge[0]), row(positions, pair.edge[1]));
  const falling = facet.sides.filter(({ pair }) => isFalling(facts, pair));
  const sum = falling.map(lengthOf).reduce((a, b) => a + b, 0);
  return sum > 1.7 * long;
}

/** Whether the second face of a pair falls away from the first as at a bevel. */
function isFalling({ mesh, normals }: SurfaceFacts, { angle, edge, faces, opposite }: Pair): boolean {
  const across = subtract(row(mesh.positions, opposite[1]), row(mesh.positions, edge[0]));
  return angle > limits.least && angle < limits.most && dot(normals[faces[0]]!, across) < 0;
}

function verticesOf({ mesh }: SurfaceFacts, { faces }: Facet): number[] {
  return [...new Set(faces.flatMap((face) => [...mesh.triangles.subarray(3 * face, 3 * face + 3)]))];
}
