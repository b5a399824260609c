import { add, cross, dot, length, scale, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';

/** A face of a convex polyhedron: its corners, counter-clockwise seen from outside. */
export interface ZonotopeFace {
  readonly normal: Vec3;
  readonly corners: readonly Vec3[];
}

/**
 * The polyhedron that rows of B draw normals to (2019, §4): the sum of segments along its rows, each as long as the row. Its faces are
 * those of the style, its width along a direction p is |B p|₁.
 *
 * @param rows any number, of any length; two that are parallel are one of their lengths' sum
 * @returns no faces where all rows lie in a plane
 */
export function zonotopeFaces(rows: readonly Vec3[]): readonly ZonotopeFace[] {
  const distinct = joined(rows);
  const faces: ZonotopeFace[] = [];
  for (let i = 0; i < distinct.length; i++) {
    for (let j = i + 1; j < distinct.length; j++) {
      const normal = unit(cross(distinct[i]!, distinct[j]!));
      for (const outward of [normal, scale(normal, -1)]) {
        if (faces.some((face) => dot(face.normal, outward) > 1 - parallel)) continue;
        const face = faceAt(distinct, outward);
        if (face) faces.push(face);
      }
    }
  }
  return faces;
}

/** Directions whose cosine differs from 1 by less are one. */
const parallel = 1e-9;

/** The face that looks in a direction; null where it would be no face, as all rows lie in its plane. */
function faceAt(rows: readonly Vec3[], normal: Vec3): ZonotopeFace | null {
  const inPlane = rows.filter((row) => Math.abs(dot(row, normal)) <= 1e-6 * length(row));
  const across = rows.filter((row) => !inPlane.includes(row));
  if (across.length === 0) return null;
  const center = across.reduce<Vec3>(
    (sum, row) => add(sum, scale(row, Math.sign(dot(row, normal)) / 2)),
    [0, 0, 0],
  );
  // Edges in the order of their directions, each once forth and once back, go around the face.
  const first = unit(inPlane[0]!);
  const second = cross(normal, first);
  const turned = inPlane
    .map((row) =>
      dot(row, second) < 0 || (dot(row, second) === 0 && dot(row, first) < 0) ? scale(row, -1) : row,
    )
    .sort((a, b) => angle(a, first, second) - angle(b, first, second));
  let corner = subtract(center, scale(turned.reduce(add), 0.5));
  const corners: Vec3[] = [];
  for (const edge of [...turned, ...turned.map((row) => scale(row, -1))]) {
    corners.push(corner);
    corner = add(corner, edge);
  }
  return { normal, corners };
}

const angle = (row: Vec3, first: Vec3, second: Vec3): number => Math.atan2(dot(row, second), dot(row, first));

/** Rows without those of no length, parallel ones as one. */
function joined(rows: readonly Vec3[]): Vec3[] {
  const distinct: Vec3[] = [];
  for (const row of rows) {
    if (!(length(row) > 0)) continue;
    const known = distinct.findIndex((other) => Math.abs(dot(unit(other), unit(row))) > 1 - parallel);
    if (known < 0) distinct.push(row);
    else {
      const other = distinct[known]!;
      distinct[known] = add(other, dot(other, row) < 0 ? scale(row, -1) : row);
    }
  }
  return distinct;
}
