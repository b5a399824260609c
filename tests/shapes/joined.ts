import { distance, type Vec3 } from '../../src/mesh/vectors.ts';
import { extrude } from './extruded.ts';
import type { Fineness } from './fineness.ts';
import { isAround } from './flat.ts';
import { arc, disc, hole, polygon, rectangle, sampled } from './outline.ts';
import type { Loop, Vec2 } from './plane.ts';
import { stitch } from './revolved.ts';
import { assembled, type Shape } from './shape.ts';
import { Solid } from './solid.ts';

const turn = 2 * Math.PI;
const up: Vec3 = [0, 0, 1];
const level =
  (height: number) =>
  ([x, y]: Vec2): Vec3 => [x, y, height];
/** A plane that is seen from below, in points with x mirrored. */
const under =
  (height: number) =>
  ([x, y]: Vec2): Vec3 => [-x, y, height];
const mirrored = (loop: Loop): Loop => loop.map(([x, y]): Vec2 => [-x, y]).toReversed();

/** A bolt that stands on its head, a hexagon of radius 1; the thread is a row of rings, radius 0.5 outside. */
export function bolt(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [radius, depth, pitch, low, high] = [0.5, 0.08, 0.25, 0.6, 3.6];
  const hexagon = polygon(
    ...Array.from({ length: 6 }, (_, k): Vec2 => [Math.cos((turn * k) / 6), Math.sin((turn * k) / 6)]),
  );
  const rim = sampled(hexagon, fineness);
  solid.fill([mirrored(rim)], under(0));
  solid.fill([rim, sampled(hole([0, 0], radius), fineness)], level(low));
  solid.sides({ outline: hexagon, low: 0, high: low });
  const columns = fineness.arc(radius, turn);
  const count = Math.round((2 * (high - low)) / pitch);
  const ringAt = (k: number): number[] =>
    Array.from({ length: columns }, (_, j) => {
      const [angle, r] = [(turn * (j + (k % 2) / 2)) / columns, radius - (k % 2) * depth];
      return solid.vertex([r * Math.cos(angle), r * Math.sin(angle), low + (k * pitch) / 2]);
    });
  for (let k = 0; k < count; k++) stitch(solid, ringAt(k), ringAt(k + 1));
  solid.fill([ringAt(count).map((v): Vec2 => [solid.at(v)[0], solid.at(v)[1]])], level(high));
  const within = (at: Vec3) => at[2] > low - 1e-6;
  solid.round('ridges', (at) => within(at) && isAround(up, radius)(at), up);
  solid.round('grooves', (at) => within(at) && isAround(up, radius - depth)(at), up);
  return solid.shape('bolt', { head: ([, , z]) => z < low + 1e-6 });
}

/** A mug with its handle towards x. */
export function mug(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [outer, inner, floor, height, thick, reach] = [1, 0.88, 0.16, 2.2, 0.14, 0.2] as const;
  const [low, high] = [0.6, 1.7];
  const count = fineness.arc(thick, turn);
  const path = handlePath({ outer, low, high, reach }, fineness);
  const ringAt = (k: number): Vec3[] => {
    const { at, slope } = path[k]!;
    const isEnd = k === 0 || k === path.length - 1;
    return Array.from({ length: count }, (_, j): Vec3 => {
      const angle = (turn * (j + (k % 2) / 2)) / count;
      const [y, out] = [thick * Math.cos(angle), thick * Math.sin(angle)];
      const x = isEnd ? Math.sqrt(outer ** 2 - y ** 2) : at[0] - out * Math.sin(slope);
      return [x, y, at[1] + out * Math.cos(slope)];
    });
  };
  const foot = (k: number): Loop =>
    ringAt(k).map(([, y, z]): Vec2 => [outer * (Math.PI + Math.asin(y / outer)), z]);
  const wall = [arc([0, 0], outer, -Math.PI, Math.PI)];
  solid.sides({
    outline: wall,
    low: 0,
    high: height,
    holes: new Map([[0, [foot(0), foot(path.length - 1)]]]),
  });
  const vertices = (k: number) => ringAt(k).map((at) => solid.vertex(at));
  for (let k = 1; k < path.length; k++) stitch(solid, vertices(k - 1), vertices(k));
  const outside = sampled(wall, fineness);
  const inside = sampled(hole([0, 0], inner), fineness);
  solid.fill([mirrored(outside)], under(0));
  solid.fill([outside, inside], level(height));
  solid.fill([inside.toReversed()], level(floor));
  solid.sides({ outline: hole([0, 0], inner), low: floor, high: height });
  solid.round('outside', ([x, y, z]) => isAround(up, outer)([x, y, z]), up);
  solid.round('inside', isAround(up, inner), up);
  return solid.shape('mug', {
    handle: (at) => distance(at, [at[0], 0, at[2]]) < thick + 1e-6 && at[0] > outer,
  });
}

/** The middle line of a handle in (x, z) with its slope, in radians: out, around and back. */
function handlePath(
  { outer, low, high, reach }: { outer: number; low: number; high: number; reach: number },
  fineness: Fineness,
): { at: Vec2; slope: number }[] {
  const radius = (high - low) / 2;
  const rows = 2 * Math.max(4, Math.round(fineness.arc(radius, Math.PI) / 2));
  const bend = arc([outer + reach, (low + high) / 2], radius, -Math.PI / 2, Math.PI / 2);
  const middle = Array.from({ length: rows + 1 }, (_, k) => ({
    at: bend.at(k / rows),
    slope: (Math.PI * k) / rows,
  }));
  return [{ at: [outer, low], slope: 0 }, ...middle, { at: [outer, high], slope: Math.PI }];
}

/** A plate with one hole and a pin in it, thinner by a gap. */
export function pinInHole(fineness: Fineness, gap = 0): Shape {
  const [plate, pin] = [new Solid(fineness), new Solid(fineness)];
  const holes = [{ name: 'hole', at: [2, 1] as const, radius: 0.4 }];
  extrude(plate, { outline: rectangle(0, 0, 4, 2), low: 0, high: 0.4, holes });
  extrude(pin, { outline: disc([2, 1], 0.4 - gap), low: -0.3, high: 0.8 });
  pin.round('side', ([x, y]) => Math.abs(Math.hypot(x - 2, y - 1) - 0.4 + gap) < 1e-6, up);
  return assembled(`pin in a hole${gap > 0 ? ', with a gap' : ''}`, {
    plate: plate.shape('plate'),
    pin: pin.shape('pin'),
  });
}
