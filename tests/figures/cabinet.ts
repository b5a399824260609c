import type { Fineness } from '../shapes/fineness.ts';
import { facet } from '../shapes/flat.ts';
import { hole, rectangle, sampled } from '../shapes/outline.ts';
import type { Shape } from '../shapes/shape.ts';
import { Solid } from '../shapes/solid.ts';

/** Where the compartments begin and end, along x. */
const walls = [0, 1.2, 2.8, 4] as const;
const [depth, height, radius] = [1.6, 1.2, 0.35] as const;

/**
 * A box of three compartments, open in front; two walls without thickness part them, each with a round opening. Where such
 * a wall meets the outside three faces share an edge.
 */
export function cabinet(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  for (const [k, from] of walls.slice(0, -1).entries()) {
    const to = walls[k + 1]!;
    facet(solid, [to, depth, 0], [from, depth, 0], [from, depth, height], [to, depth, height]);
    facet(solid, [from, depth, 0], [to, depth, 0], [to, 0, 0], [from, 0, 0]);
    facet(solid, [from, 0, height], [to, 0, height], [to, depth, height], [from, depth, height]);
  }
  facet(solid, [0, depth, 0], [0, 0, 0], [0, 0, height], [0, depth, height]);
  facet(solid, [4, 0, 0], [4, depth, 0], [4, depth, height], [4, 0, height]);
  const middle = [depth / 2, height / 2] as const;
  for (const x of walls.slice(1, -1)) {
    const loops = [rectangle(0, 0, depth, height), hole(middle, radius)].map((outline) =>
      sampled(outline, fineness),
    );
    solid.fill(loops, ([y, z]) => [x, y, z]);
    const isRim = ([a, y, z]: readonly [number, number, number]) =>
      Math.abs(a - x) < 1e-6 && Math.abs(Math.hypot(y - middle[0], z - middle[1]) - radius) < 1e-6;
    solid.round(`hole at ${x}`, isRim, [1, 0, 0]);
  }
  return solid.shape('cabinet');
}
