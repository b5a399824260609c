import { add, cross, scale, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { LinesLayer } from '../../src/viewer/layers/layer.ts';
import type { Hit } from '../../src/viewer/picking/picking.ts';

const points = 48;

/** The rim of a brush that lies on the surface. @param radius in the file's units */
export function brushRing({ point, normal }: Pick<Hit, 'point' | 'normal'>, radius: number): LinesLayer {
  const first = across(normal);
  const second = cross(normal, first);
  const at = (k: number): Vec3 => {
    const angle = (2 * Math.PI * k) / points;
    const out = add(scale(first, Math.cos(angle)), scale(second, Math.sin(angle)));
    return add(point, scale(out, radius));
  };
  const places = Array.from({ length: points }, (_, k) => [...at(k), ...at(k + 1)]).flat();
  return { kind: 'lines', places, width: 2, color: '#2f2a26', depth: 'faint-behind' };
}

/** Some direction across another, unit. */
export function across(normal: Vec3): Vec3 {
  const [x, y, z] = normal.map(Math.abs) as [number, number, number];
  return unit(cross(normal, x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1]));
}
