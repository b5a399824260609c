/** A point of the plane. */
export type Vec2 = readonly [x: number, y: number];

/** A closed line through points; the last joins the first. */
export type Loop = readonly Vec2[];

export const distance2 = (a: Vec2, b: Vec2): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Twice the signed area of a triangle, positive if its corners go round counter-clockwise. */
export const turn = (a: Vec2, b: Vec2, c: Vec2): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

export function distanceToSegment(p: Vec2, a: Vec2, b: Vec2): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const along = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
  const share = Math.max(0, Math.min(1, along));
  return distance2(p, [a[0] + share * dx, a[1] + share * dy]);
}

/** Whether a point lies inside an odd number of loops. */
export function isInside(p: Vec2, loops: readonly Loop[]): boolean {
  let inside = false;
  for (const loop of loops) {
    let a = loop.at(-1)!;
    for (const b of loop) {
      if (a[1] > p[1] !== b[1] > p[1] && p[0] < a[0] + ((p[1] - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) {
        inside = !inside;
      }
      a = b;
    }
  }
  return inside;
}

/** Twice the signed area inside a loop. */
export function doubledArea(loop: Loop): number {
  return loop.reduce((sum, a, i) => {
    const b = loop[(i + 1) % loop.length]!;
    return sum + a[0] * b[1] - b[0] * a[1];
  }, 0);
}
