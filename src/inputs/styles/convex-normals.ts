import { WhittleError } from '../../mesh/failure.ts';
import { add, dot, length, row, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';
import { areaVectors, type Surface } from './surface.ts';

/** Faces whose normals differ by less than this share one direction: 0.5°. */
const sameDirection = Math.cos((0.5 * Math.PI) / 180);
/** How far a vertex may stand out over a face's plane, as a share of the box's diagonal. */
const convexityTolerance = 0.01;
/** Beyond this the closest direction is so close that the style would show nowhere. */
const mostDirections = 2000;

interface Direction {
  /** The normal of its largest face; others are held against that, so that directions cannot creep round a curve. */
  readonly seed: Vec3;
  areaVector: Vec3;
  readonly faces: number[];
}

/**
 * The distinct unit normals of a convex surface: what the closest-normal mapping of a style takes (2021, §3.1). Faces of
 * one direction (to 0.5°) count as one, with their area-weighted mean; faces without area are passed over.
 *
 * @returns #N×3, the direction of the largest area first
 * @throws WhittleError `unsuitable-mesh` where vertices stand out over a face by more than 1 % of the box's diagonal (its
 *   element is that face; the sentence says how far), or where there are more than 2000 directions
 */
export function normalsOfConvex(surface: Surface): Float64Array<ArrayBuffer> {
  const directions = distinctDirections(surface);
  requireConvex(surface, directions);
  directions.sort((a, b) => length(b.areaVector) - length(a.areaVector));
  return Float64Array.from(directions.flatMap(({ areaVector }) => unit(areaVector)));
}

function distinctDirections(surface: Surface): Direction[] {
  const vectors = areaVectors(surface);
  const areas = Array.from({ length: vectors.length / 3 }, (_, face) => length(row(vectors, face)));
  const largest = areas.reduce((most, area) => Math.max(most, area), 0);
  const faces = [...areas.keys()].filter((face) => areas[face]! > 1e-12 * largest);
  faces.sort((a, b) => areas[b]! - areas[a]!);
  const directions: Direction[] = [];
  for (const face of faces) {
    const areaVector = row(vectors, face);
    const normal = unit(areaVector);
    const known = directions.find(({ seed }) => dot(seed, normal) > sameDirection);
    if (known) {
      known.areaVector = add(known.areaVector, areaVector);
      known.faces.push(face);
    } else {
      directions.push({ seed: normal, areaVector, faces: [face] });
      if (directions.length > mostDirections) throw tooMany();
    }
  }
  if (directions.length === 0)
    throw new WhittleError('unsuitable-mesh', 'The style has no face with an area; choose another shape.');
  return directions;
}

function tooMany(): WhittleError {
  return new WhittleError(
    'unsuitable-mesh',
    `The style has more than ${mostDirections} face directions: it is smooth. Use the spherical mapping for it.`,
  );
}

/** Every face must lie in a plane that has no vertex before it. */
function requireConvex(surface: Surface, directions: readonly Direction[]): void {
  const { positions, triangles } = surface;
  const size = diagonal(positions);
  const vertices = Uint32Array.from(new Set(triangles));
  let worst = { share: 0, face: -1 };
  for (const { areaVector, faces } of directions) {
    const normal = unit(areaVector);
    const heightOf = (vertex: number): number => dot(normal, row(positions, vertex));
    let top = -Infinity;
    for (const vertex of vertices) top = Math.max(top, heightOf(vertex));
    for (const face of faces) {
      const mean = [0, 1, 2].reduce((sum, k) => sum + heightOf(triangles[3 * face + k]!) / 3, 0);
      const share = (top - mean) / size;
      if (share > worst.share) worst = { share, face };
    }
  }
  if (worst.share <= convexityTolerance) return;
  throw new WhittleError(
    'unsuitable-mesh',
    `The style is not convex: vertices stand out over face ${worst.face} by ${(100 * worst.share).toFixed(1)} % of its size ` +
      `(${100 * convexityTolerance} % would do). Use the spherical mapping for it, or a convex shape.`,
    worst.face,
  );
}

function diagonal(positions: Float64Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let p = 0; p < positions.length; p++) {
    low[p % 3] = Math.min(low[p % 3]!, positions[p]!);
    high[p % 3] = Math.max(high[p % 3]!, positions[p]!);
  }
  return length(subtract(high as unknown as Vec3, low as unknown as Vec3));
}
