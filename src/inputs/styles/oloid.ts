import type { Mesh } from '../../mesh/mesh.ts';
import { between, type Vec3 } from '../../mesh/vectors.ts';
import { lengthOf, RowMesh, resampled } from './rows.ts';

/** Where the two circles' arcs end: the last generating line lies in the plane of the first circle. */
const arcEnd = (2 * Math.PI) / 3;
const samples = 4000;

/** On the circle in the plane z = 0, around (0, −½, 0). */
const onFirst = (t: number): Vec3 => [Math.sin(t), -0.5 - Math.cos(t), 0];

/** The other end of the generating line, on the upper half of the circle in the plane x = 0, around (0, ½, 0). */
function onSecond(t: number): Vec3 {
  const cosine = Math.cos(t);
  const under = 1 + 2 * cosine;
  // At the arc's end the root would blow rounding up to 1e-8, and the halves would not meet.
  return [0, 0.5 - cosine / (1 + cosine), Math.abs(t) === arcEnd ? 0 : Math.sqrt(under) / (1 + cosine)];
}

/**
 * The oloid: the convex hull of two circles of radius 1 in planes at right angles, each through the other's centre. It is
 * developable, with lines of length √3 from circle to circle and two sharp arcs.
 *
 * @param resolution rows of triangles from circle to circle
 */
export function oloid(resolution: number): Mesh {
  const mesh = new RowMesh();
  const edge = Math.sqrt(3) / resolution;
  for (const side of [1, -1]) {
    let below: readonly number[] | undefined;
    for (let k = 0; k <= resolution; k++) {
      const half = halfRow(k / resolution, edge).map(([x, y, z]): Vec3 => [x, y, side * z]);
      const mirrored = half.slice(1).map(([x, y, z]): Vec3 => [-x, y, z]);
      const points = [...mirrored.reverse(), ...half];
      const row = mesh.add(side > 0 ? points : points.reverse());
      if (below) mesh.stitch(below, row);
      below = row;
    }
  }
  return mesh.mesh();
}

/** The row at a share of all lines, from its middle to the end with positive x; equally spaced. */
function halfRow(share: number, edge: number): Vec3[] {
  const line = Array.from({ length: samples + 1 }, (_, k): Vec3 => {
    // The sine slows down at the end, where the second circle's arc has the slope of a root.
    const t = k === samples ? arcEnd : arcEnd * Math.sin((Math.PI * k) / (2 * samples));
    return between(onFirst(t), onSecond(t), share);
  });
  return resampled(line, Math.max(2, Math.round(lengthOf(line) / edge)));
}
