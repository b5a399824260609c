import { add, row, scale, unit, type Vec3 } from '../../mesh/vectors.ts';
import type { GaussMap } from '../../methods/values/gauss-map.ts';
import { SphereLocator } from './sphere-locator.ts';

/** Says which normal a style wants where the input has the given one (unit; the answer is too). */
export type GaussLookup = (normal: Vec3) => Vec3;

/** A style as a function, for pictures and measures; the core has its own for solving. */
export function lookup(map: GaussMap): GaussLookup {
  if (map.kind === 'closest') return (normal) => closest(map.normals, normal);
  const { points, triangles, normals, per } = map;
  const locator = new SphereLocator(points, triangles);
  return (normal) => {
    const { face, weights } = locator.locate(normal);
    if (per === 'face') return row(normals, face);
    const corner = (k: 0 | 1 | 2): Vec3 => scale(row(normals, triangles[3 * face + k]!), weights[k]);
    return unit(add(add(corner(0), corner(1)), corner(2)));
  };
}

function closest(normals: Float64Array, [x, y, z]: Vec3): Vec3 {
  let best = 0;
  let nearest = -Infinity;
  for (let n = 0; 3 * n < normals.length; n++) {
    const cosine = x * normals[3 * n]! + y * normals[3 * n + 1]! + z * normals[3 * n + 2]!;
    if (cosine > nearest) {
      nearest = cosine;
      best = n;
    }
  }
  return row(normals, best);
}
