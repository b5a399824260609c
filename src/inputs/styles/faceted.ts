import { cross, distance, dot, length, row } from '../../mesh/vectors.ts';
import { areaVectors, type Surface } from './surface.ts';

/** Edges flatter than this lie within a facet, sharper ones than that between two: degrees. */
const flat = 0.5;
const sharp = 15;
/** Share of the edges' length that may be neither. */
const tolerated = 0.1;

/**
 * Whether a surface is made of flat facets, so that its normals jump from one to the next. Nearly all of its edges (by length)
 * are then flat or sharp; on a smooth surface most bend a little.
 *
 * @param surface with welded vertices
 */
export function isFaceted(surface: Surface): boolean {
  const { positions, triangles } = surface;
  const vectors = areaVectors(surface);
  const faceOfEdge = new Map<string, number>();
  let all = 0;
  let between = 0;
  for (let corner = 0; corner < triangles.length; corner++) {
    const face = Math.floor(corner / 3);
    const from = triangles[corner]!;
    const to = triangles[3 * face + ((corner + 1) % 3)]!;
    const other = faceOfEdge.get(`${to} ${from}`);
    faceOfEdge.set(`${from} ${to}`, face);
    if (other === undefined) continue;
    const [a, b] = [row(vectors, face), row(vectors, other)];
    const angle = (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;
    const edge = distance(row(positions, from), row(positions, to));
    all += edge;
    if (angle > flat && angle < sharp) between += edge;
  }
  return between <= tolerated * all;
}
