import { turn, type Vec2 } from './plane.ts';

/** Triangle: corners counter-clockwise, and beyond the side opposite to each the neighbour, −1 if there is none. */
interface Triangle {
  readonly corners: readonly [number, number, number];
  readonly beyond: [number, number, number];
}

/**
 * Corners of the Delaunay triangles of points in general position, three by three and counter-clockwise, by inserting one point
 * after the other (Bowyer 1981, Watson 1981). It is fast where points that follow each other lie near each other.
 */
export function delaunay(points: readonly Vec2[]): number[] {
  const all = [...points, ...around(points)];
  const work = new Triangulation(all, points.length);
  for (let p = 0; p < points.length; p++) work.insert(p);
  return work.triangles().flatMap(({ corners }) => (corners.some((c) => c >= points.length) ? [] : corners));
}

/** Corners of a triangle far outside. */
function around(points: readonly Vec2[]): Vec2[] {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const middle = (values: number[]) => (Math.min(...values) + Math.max(...values)) / 2;
  const size = 1e3 * Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  const [x, y] = [middle(xs), middle(ys)];
  return [
    [x - 2 * size, y - size],
    [x + 2 * size, y - size],
    [x, y + 2 * size],
  ];
}

class Triangulation {
  readonly #points: readonly Vec2[];
  readonly #triangles: (Triangle | null)[];
  #last = 0;

  constructor(points: readonly Vec2[], outer: number) {
    this.#points = points;
    this.#triangles = [{ corners: [outer, outer + 1, outer + 2], beyond: [-1, -1, -1] }];
  }

  triangles(): Triangle[] {
    return this.#triangles.filter((triangle) => triangle !== null);
  }

  insert(p: number): void {
    const cavity = this.#cavity(this.#locate(p), p);
    /** The new triangle by the point that its side on the rim of the cavity begins at. */
    const from = new Map<number, number>();
    const made: number[] = [];
    for (const [a, b, outside] of this.#rim(cavity)) {
      const t = this.#triangles.push({ corners: [p, a, b], beyond: [outside, -1, -1] }) - 1;
      if (outside >= 0) this.#join(outside, b, a, t);
      from.set(a, t);
      made.push(t);
    }
    for (const t of made) {
      const next = from.get(this.#triangles[t]!.corners[2])!;
      this.#triangles[t]!.beyond[1] = next;
      this.#triangles[next]!.beyond[2] = t;
    }
    for (const t of cavity) this.#triangles[t] = null;
    this.#last = made[0]!;
  }

  /** Walks to the triangle that a point lies in. */
  #locate(p: number): number {
    let t = this.#last;
    for (;;) {
      const { corners, beyond } = this.#triangles[t]!;
      const side = [0, 1, 2].find((k) => this.#turn(corners[(k + 1) % 3]!, corners[(k + 2) % 3]!, p) < 0);
      if (side === undefined) return t;
      t = beyond[side]!;
    }
  }

  /** The triangles whose circle a point lies in. */
  #cavity(start: number, p: number): Set<number> {
    const cavity = new Set([start]);
    for (const t of cavity) {
      for (const next of this.#triangles[t]!.beyond) {
        if (next >= 0 && !cavity.has(next) && this.#isInCircle(this.#triangles[next]!.corners, p))
          cavity.add(next);
      }
    }
    return cavity;
  }

  #rim(cavity: ReadonlySet<number>): [number, number, number][] {
    return [...cavity].flatMap((t) => {
      const { corners, beyond } = this.#triangles[t]!;
      const sides = [0, 1, 2].filter((k) => beyond[k]! < 0 || !cavity.has(beyond[k]!));
      return sides.map((k): [number, number, number] => [
        corners[(k + 1) % 3]!,
        corners[(k + 2) % 3]!,
        beyond[k]!,
      ]);
    });
  }

  /** Says to a triangle what lies beyond its side from a to b. */
  #join(t: number, a: number, b: number, beyond: number): void {
    const { corners } = this.#triangles[t]!;
    const side = [0, 1, 2].find((k) => corners[(k + 1) % 3] === a && corners[(k + 2) % 3] === b)!;
    this.#triangles[t]!.beyond[side] = beyond;
  }

  #turn(a: number, b: number, c: number): number {
    return turn(this.#points[a]!, this.#points[b]!, this.#points[c]!);
  }

  #isInCircle(corners: readonly number[], p: number): boolean {
    const [a, b, c, centre] = [
      this.#points[corners[0]!]!,
      this.#points[corners[1]!]!,
      this.#points[corners[2]!]!,
      this.#points[p]!,
    ];
    const square = (q: Vec2) => (q[0] - centre[0]) ** 2 + (q[1] - centre[1]) ** 2;
    return (
      square(a) * turn(centre, b, c) + square(b) * turn(centre, c, a) + square(c) * turn(centre, a, b) > 0
    );
  }
}
