/** Dot products of the two edges at each corner of a face, and twice its area: all that its angles and areas need. */
export type FaceShape = [dot0: number, dot1: number, dot2: number, doubledArea: number];

/** @param positions #V×3   @param face a face of `triangles` (#F×3) */
export function measureFace(
  positions: Float64Array,
  triangles: Uint32Array,
  face: number,
  into: FaceShape,
): void {
  const x = positions;
  const a = 3 * triangles[3 * face]!;
  const b = 3 * triangles[3 * face + 1]!;
  const c = 3 * triangles[3 * face + 2]!;
  const ux = x[b]! - x[a]!;
  const uy = x[b + 1]! - x[a + 1]!;
  const uz = x[b + 2]! - x[a + 2]!;
  const vx = x[c]! - x[a]!;
  const vy = x[c + 1]! - x[a + 1]!;
  const vz = x[c + 2]! - x[a + 2]!;
  const dot = ux * vx + uy * vy + uz * vz;
  into[0] = dot;
  into[1] = ux * ux + uy * uy + uz * uz - dot;
  into[2] = vx * vx + vy * vy + vz * vz - dot;
  into[3] = Math.sqrt((uy * vz - uz * vy) ** 2 + (uz * vx - ux * vz) ** 2 + (ux * vy - uy * vx) ** 2);
}

/** Area of the faces around each vertex, #V. */
export function ringAreas(positions: Float64Array, triangles: Uint32Array): Float64Array<ArrayBuffer> {
  const areas = new Float64Array(positions.length / 3);
  const shape: FaceShape = [0, 0, 0, 0];
  for (let face = 0; 3 * face < triangles.length; face++) {
    measureFace(positions, triangles, face, shape);
    for (let k = 0; k < 3; k++) areas[triangles[3 * face + k]!] += shape[3] / 2;
  }
  return areas;
}

/** Mixed Voronoi area of each vertex, #V: a share of every face around it, all shares together the whole surface. */
export function mixedAreas(positions: Float64Array, triangles: Uint32Array): Float64Array<ArrayBuffer> {
  const areas = new Float64Array(positions.length / 3);
  const shape: FaceShape = [0, 0, 0, 0];
  for (let face = 0; 3 * face < triangles.length; face++) {
    measureFace(positions, triangles, face, shape);
    if (shape[3] === 0) continue;
    for (let k = 0; k < 3; k++) areas[triangles[3 * face + k]!] += mixedShare(shape, k);
  }
  return areas;
}

function mixedShare(shape: FaceShape, corner: number): number {
  const doubledArea = shape[3];
  const [here, next, last] = [shape[corner]!, shape[(corner + 1) % 3]!, shape[(corner + 2) % 3]!];
  if (here < 0) return doubledArea / 4;
  if (next < 0 || last < 0) return doubledArea / 8;
  // ⅛ Σ cot(opposite angle) |edge|² over the two edges at the corner; an edge's square is the sum of the dots at its ends.
  return (next * (here + last) + last * (here + next)) / (8 * doubledArea);
}
