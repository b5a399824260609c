import { WhittleError } from '../../mesh/failure.ts';
import { add, length, row, scale, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';
import { gather, solvedTriangles, weldOf } from '../../mesh/weld.ts';
import { areaVectors, type Surface, volume } from './surface.ts';

/** A style's normals on the unit sphere: the Gauss map A → A′ of an analogy, as the core takes it. */
export interface SphereNormals {
  /** #V×3, unit. */
  readonly points: Float64Array<ArrayBuffer>;
  /** #F×3 indices into `points`, counter-clockwise from outside. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** #V×3, unit: area-weighted normals of the style's vertices. */
  readonly vertexNormals: Float64Array<ArrayBuffer>;
  /** #F×3, unit: for faceted styles, whose edges a mean would round. */
  readonly faceNormals: Float64Array<ArrayBuffer>;
}

/** How far from round the flowed points may be, as a share of the radius. */
const roundness = 1e-3;

/**
 * Puts a style mesh's normals on the sphere to which the method `spherical` has let it flow. Equal positions count as one
 * vertex, and a mesh given inside out is turned.
 *
 * @param style the mesh as it was
 * @param flowed the same positions after the flow, #P×3; on a sphere around the style's area centroid
 * @throws WhittleError `unsuitable-mesh` if they are on no sphere, as when the flow was stopped before its end
 */
export function sphereNormals(style: Surface, flowed: Float64Array): SphereNormals {
  const weld = weldOf(style);
  const triangles = solvedTriangles(weld);
  const { vertexOfPosition } = weld;
  const positions = gather(style.positions, weld);
  const surface: Surface = {
    positions,
    triangles: volume({ positions, triangles }) < 0 ? turnedOver(triangles) : triangles,
  };
  const vectors = areaVectors(surface);
  const points = new Float64Array(positions.length);
  const center = areaCentroid(surface, vectors);
  for (let p = 0; p < vertexOfPosition.length; p++) {
    points.set(subtract(row(flowed, p), center), 3 * vertexOfPosition[p]!);
  }
  projectToUnitSphere(points, surface.triangles);
  return {
    points,
    triangles: surface.triangles as Uint32Array<ArrayBuffer>,
    vertexNormals: vertexNormals(surface, vectors),
    faceNormals: mapRows(vectors, unit),
  };
}

function turnedOver(triangles: Uint32Array): Uint32Array<ArrayBuffer> {
  return triangles.map(
    (_, corner) => triangles[corner - (corner % 3) + (2 - (corner % 3))]!,
  ) as Uint32Array<ArrayBuffer>;
}

function mapRows(array: Float64Array, change: (row: Vec3) => Vec3): Float64Array<ArrayBuffer> {
  const result = new Float64Array(array.length);
  for (let r = 0; 3 * r < array.length; r++) result.set(change(row(array, r)), 3 * r);
  return result;
}

function areaCentroid({ positions, triangles }: Surface, vectors: Float64Array): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  let area = 0;
  for (let corner = 0; corner < triangles.length; corner++) {
    const share = length(row(vectors, Math.floor(corner / 3)));
    sum = add(sum, scale(row(positions, triangles[corner]!), share));
    area += share;
  }
  return scale(sum, 1 / area);
}

/** In place; vertices that no face uses may be anywhere. */
function projectToUnitSphere(points: Float64Array, triangles: Uint32Array): void {
  let least = Infinity;
  let most = 0;
  for (const vertex of triangles) {
    const radius = length(row(points, vertex));
    least = Math.min(least, radius);
    most = Math.max(most, radius);
  }
  if (!(most - least <= roundness * most)) {
    const spread = (100 * (most - least)) / most;
    throw new WhittleError(
      'unsuitable-mesh',
      `The style did not flow to a sphere: its radii differ by ${spread.toFixed(1)} %. ` +
        'Let the flow run to its end, or remesh the style more evenly.',
    );
  }
  points.set(mapRows(points, unit));
}

function vertexNormals({ positions, triangles }: Surface, vectors: Float64Array): Float64Array<ArrayBuffer> {
  const sums = new Float64Array(positions.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const face = Math.floor(corner / 3);
    for (let axis = 0; axis < 3; axis++) sums[3 * triangles[corner]! + axis]! += vectors[3 * face + axis]!;
  }
  return mapRows(sums, unit);
}
