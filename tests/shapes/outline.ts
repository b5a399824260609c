import type { Fineness } from './fineness.ts';
import type { Loop, Vec2 } from './plane.ts';

/** A piece of an outline: straight, or an arc by radius and angles. */
export interface Stretch {
  readonly length: number;
  /** Absent where it is straight. */
  readonly radius?: number;
  /** The place at a share of it, 0 to 1. */
  at(share: number): Vec2;
}

export interface Corner {
  readonly at: Vec2;
  /** Radius of the arc that rounds it; absent leaves it sharp. */
  readonly fillet?: number;
}

export function straight(from: Vec2, to: Vec2): Stretch {
  return {
    length: Math.hypot(to[0] - from[0], to[1] - from[1]),
    at: (s) => [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])],
  };
}

/** An arc; angles in radians, counter-clockwise if the second is larger. */
export function arc(centre: Vec2, radius: number, from: number, to: number): Stretch {
  return {
    length: radius * Math.abs(to - from),
    radius,
    at(s) {
      const angle = from + s * (to - from);
      return [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)];
    },
  };
}

/** A full turn, clockwise as holes are passed. */
export const hole = (centre: Vec2, radius: number): Stretch[] => [arc(centre, radius, 2 * Math.PI, 0)];

/** A full turn, counter-clockwise. */
export const disc = (centre: Vec2, radius: number): Stretch[] => [arc(centre, radius, 0, 2 * Math.PI)];

export function rectangle(left: number, low: number, right: number, high: number): Stretch[] {
  return polygon([left, low], [right, low], [right, high], [left, high]);
}

export const polygon = (...corners: Vec2[]): Stretch[] => rounded(corners.map((at) => ({ at })));

/** A closed polygon, some of its corners rounded. */
export function rounded(corners: readonly Corner[]): Stretch[] {
  const around = corners.map((corner, i) => {
    const before = corners.at(i - 1)!.at;
    return tangents(before, corner, corners[(i + 1) % corners.length]!.at);
  });
  return around.flatMap(({ arc, end }, i) => {
    const next = around[(i + 1) % around.length]!;
    return [...(arc ? [arc] : []), straight(end, next.start)];
  });
}

/** Where the arc in a corner begins and ends. */
function tangents(
  before: Vec2,
  { at, fillet }: Corner,
  after: Vec2,
): { start: Vec2; end: Vec2; arc?: Stretch } {
  if (!fillet) return { start: at, end: at };
  const towards = (to: Vec2): Vec2 => {
    const size = Math.hypot(to[0] - at[0], to[1] - at[1]);
    return [(to[0] - at[0]) / size, (to[1] - at[1]) / size];
  };
  const [u, v] = [towards(before), towards(after)];
  const side = Math.sign(u[1] * v[0] - u[0] * v[1]); // 1 where the outline turns left
  const half = Math.acos(u[0] * v[0] + u[1] * v[1]) / 2;
  const reach = fillet / Math.tan(half);
  const start: Vec2 = [at[0] + reach * u[0], at[1] + reach * u[1]];
  const centre: Vec2 = [start[0] + side * fillet * u[1], start[1] - side * fillet * u[0]];
  const from = Math.atan2(start[1] - centre[1], start[0] - centre[0]);
  return {
    start,
    end: [at[0] + reach * v[0], at[1] + reach * v[1]],
    arc: arc(centre, fillet, from, from + side * (Math.PI - 2 * half)),
  };
}

/** Number of pieces that a stretch is cut into. */
export function pieces({ length, radius }: Stretch, fineness: Fineness): number {
  return radius === undefined ? fineness.line(length) : fineness.arc(radius, length / radius);
}

/** The points of a closed outline, each once. */
export function sampled(outline: readonly Stretch[], fineness: Fineness): Loop {
  return outline.flatMap((stretch) => {
    const count = pieces(stretch, fineness);
    return Array.from({ length: count }, (_, k) => stretch.at(k / count));
  });
}
