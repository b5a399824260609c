import type { Vec3 } from '../../src/mesh/vectors.ts';
import { type Stretch, sampled } from './outline.ts';
import type { Loop } from './plane.ts';
import type { Bore, Solid } from './solid.ts';

export interface Extruded {
  /** Counter-clockwise in (x, y). */
  readonly outline: readonly Stretch[];
  readonly low: number;
  readonly high: number;
  /** Holes from bottom to top. */
  readonly holes?: readonly Hole[];
  /** Holes in the side of a stretch, in (length along it, height). */
  readonly sideHoles?: ReadonlyMap<number, readonly Loop[]>;
  /** Puts it into space; absent leaves it upright. */
  readonly place?: (at: Vec3) => Vec3;
}

export interface Hole {
  readonly name: string;
  readonly at: readonly [number, number];
  readonly radius: number;
}

/** A prism with round holes. */
export function extrude(
  solid: Solid,
  { outline, low, high, holes = [], sideHoles, place = (at) => at }: Extruded,
): void {
  const rim = sampled(outline, solid.fineness);
  const bores = holes.map(({ name, at: [x, y], radius }): Bore => {
    return { name, from: place([x, y, low]), to: place([x, y, high]), radius };
  });
  const [origin, right, up] = [place([0, 0, low]), axis(place, [1, 0, 0]), axis(place, [0, 1, 0])];
  const loops = [rim, ...bores.map((bore) => solid.circle(bore, origin, right, up))];
  solid.fill(loops, ([x, y]) => place([x, y, high]));
  solid.fill(loops.map(mirrored), ([x, y]) => place([-x, y, low]));
  solid.sides({ outline, low, high, ...(sideHoles && { holes: sideHoles }) }, place);
  for (const bore of bores) solid.bore(bore);
}

/** Where a direction is taken by a placement that is rigid. */
function axis(place: (at: Vec3) => Vec3, direction: Vec3): Vec3 {
  const [from, to] = [place([0, 0, 0]), place(direction)];
  return [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
}

/** A loop seen from behind, still going round the same way. */
const mirrored = (loop: Loop): Loop => loop.map(([x, y]) => [-x, y] as const).toReversed();
