import { type FaceShape, measureFace, mixedAreas } from './areas.ts';
import { edgesOf } from './edges.ts';

/** How the faces of a mesh hang together around its vertices: what curvature needs and moving vertices does not change. */
export interface Rings {
  /** #F×3, without faces that use a vertex twice. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** #V: π (2 − edges + faces) at each vertex, from which its angles are missing: 2π inside, π at a boundary. */
  readonly fullAngle: Float64Array<ArrayBuffer>;
  /** #V: 1 where every edge has two faces. */
  readonly isInside: Uint8Array<ArrayBuffer>;
}

/** @param triangles #F×3 in welded vertices   @param vertices #V */
export function ringsOf(triangles: Uint32Array, vertices: number): Rings {
  const proper = triangles.filter((_, corner) => {
    const face = corner - (corner % 3);
    const [a, b, c] = [triangles[face], triangles[face + 1], triangles[face + 2]];
    return a !== b && b !== c && c !== a;
  }) as Uint32Array<ArrayBuffer>;
  const { ends, faces } = edgesOf(proper, proper, vertices);
  const fullAngle = new Float64Array(vertices).fill(2 * Math.PI);
  const isInside = new Uint8Array(vertices);
  for (const v of proper) {
    fullAngle[v] += Math.PI;
    isInside[v] = 1;
  }
  for (let end = 0; end < ends.length; end++) {
    fullAngle[ends[end]!] -= Math.PI;
    if (faces[end >> 1] !== 2) isInside[ends[end]!] = 0;
  }
  return { triangles: proper, fullAngle, isInside };
}

/**
 * What the angles around each vertex lack of a full turn (of half a turn at a boundary), #V, in radians. Their sum is 2π
 * times the Euler characteristic, whatever the edges are like (Gauss and Bonnet).
 *
 * @param positions #V×3
 */
export function angleDefects(positions: Float64Array, rings: Rings): Float64Array<ArrayBuffer> {
  const { triangles, fullAngle } = rings;
  const defects = fullAngle.slice();
  const shape: FaceShape = [0, 0, 0, 0];
  for (let face = 0; 3 * face < triangles.length; face++) {
    measureFace(positions, triangles, face, shape);
    for (let k = 0; k < 3; k++) defects[triangles[3 * face + k]!] -= Math.atan2(shape[3], shape[k]!);
  }
  return defects;
}

/**
 * Gaussian curvature of each vertex, #V, in one over squared units: its angle defect over its mixed Voronoi area. NaN at
 * boundaries, at edges of three faces or more and where there is no area, for there is none.
 *
 * @param positions #V×3
 */
export function gaussianCurvature(positions: Float64Array, rings: Rings): Float64Array<ArrayBuffer> {
  const curvature = angleDefects(positions, rings);
  const areas = mixedAreas(positions, rings.triangles);
  for (let v = 0; v < curvature.length; v++)
    curvature[v] = rings.isInside[v] && areas[v]! > 0 ? curvature[v]! / areas[v]! : Number.NaN;
  return curvature;
}
