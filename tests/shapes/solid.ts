import { add, cross, distance, dot, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Fineness } from './fineness.ts';
import { hole, pieces, type Stretch, sampled } from './outline.ts';
import type { Loop, Vec2 } from './plane.ts';
import type { Round, Shape } from './shape.ts';

/** Where the points of a plane or a developed surface are in space. */
export type Placed = (point: Vec2) => Vec3;

/** A straight hole or peg: from the middle of one end to that of the other. */
export interface Bore {
  readonly name: string;
  readonly from: Vec3;
  readonly to: Vec3;
  readonly radius: number;
}

/** The sides of a prism over an outline in the plane. */
export interface Prism {
  /** Counter-clockwise; clockwise for a hole. */
  readonly outline: readonly Stretch[];
  readonly low: number;
  readonly high: number;
  /** Holes in the side of that stretch, in (length along it, height). */
  readonly holes?: ReadonlyMap<number, readonly Loop[]>;
}

/** A surface in the making. Points in one place, to a millionth, are one vertex. */
export class Solid {
  readonly fineness: Fineness;
  readonly #positions: Vec3[] = [];
  readonly #triangles: number[] = [];
  readonly #cells = new Map<string, number>();
  readonly #rounds: (Round & { vertices: number[] })[] = [];

  constructor(fineness: Fineness) {
    this.fineness = fineness;
  }

  vertex(at: Vec3): number {
    const keys = cellsAround(at);
    const known = keys.map((key) => this.#cells.get(key)).find((v) => v !== undefined);
    const v = known ?? this.#positions.push(at) - 1;
    this.#cells.set(keys[0]!, v);
    return v;
  }

  at(vertex: number): Vec3 {
    return this.#positions[vertex]!;
  }

  triangle(a: number, b: number, c: number): void {
    if (a !== b && b !== c && c !== a) this.#triangles.push(a, b, c);
  }

  /** Fills loops of a plane or a developed surface; the outside is where they go round counter-clockwise. */
  fill(loops: readonly Loop[], placed: Placed): number[] {
    const { points, triangles } = this.fineness.fill(loops);
    const vertices = points.map((point) => this.vertex(placed(point)));
    for (let c = 0; c < triangles.length; c += 3) {
      const [i, j, k] = [triangles[c]!, triangles[c + 1]!, triangles[c + 2]!];
      this.triangle(vertices[i]!, vertices[j]!, vertices[k]!);
    }
    return vertices;
  }

  /** The sides of a prism, in a frame that `place` puts into space. */
  sides({ outline, low, high, holes }: Prism, place: (at: Vec3) => Vec3 = (at) => at): void {
    for (const [k, stretch] of outline.entries()) {
      const { length } = stretch;
      const placed: Placed = ([s, z]) => {
        const [x, y] = stretch.at(s / length);
        return place([x, y, z]);
      };
      const [columns, rows] = [pieces(stretch, this.fineness), this.fineness.line(high - low)];
      const inside = holes?.get(k) ?? [];
      const parts = this.fineness.strips && inside.length === 0 ? columns : 1;
      for (let part = 0; part < parts; part++) {
        const ends = [(part * length) / parts, ((part + 1) * length) / parts, columns / parts];
        this.fill([gridRim(ends, [low, high, rows]), ...inside], placed);
      }
    }
  }

  /** The wall of a round hole between two sides that have its circle in them; or, `outwards`, of a peg. */
  bore({ name, from, to, radius }: Bore, outwards = false): void {
    const axis = unit(subtract(to, from));
    const [u, v] = frame(axis);
    const circle = outwards ? hole([0, 0], radius).map(reversed) : hole([0, 0], radius);
    const before = this.#positions.length;
    const place = ([x, y, z]: Vec3): Vec3 => add(from, add(add(scale(u, x), scale(v, y)), scale(axis, z)));
    this.sides({ outline: circle, low: 0, high: distance(from, to) }, place);
    const along = (p: Vec3) => dot(subtract(p, from), axis);
    const onWall = this.#positions.flatMap((p, vertex) => {
      const off = distance(p, add(from, scale(axis, along(p))));
      const within = along(p) > -1e-6 && along(p) < distance(from, to) + 1e-6;
      return within && Math.abs(off - radius) < 1e-6 ? [vertex] : [];
    });
    if (before < this.#positions.length || onWall.length > 0)
      this.#rounds.push({ name, axis, vertices: onWall });
  }

  /** The circle of a bore as a loop in a plane with the given origin and axes, clockwise: a hole in it. */
  circle({ from, to, radius }: Bore, origin: Vec3, right: Vec3, up: Vec3): Loop {
    const axis = unit(subtract(to, from));
    const [u, v] = frame(axis);
    const normal = cross(right, up);
    const middle = subtract(from, scale(axis, dot(subtract(from, origin), normal) / dot(axis, normal)));
    return sampled(hole([0, 0], radius), this.fineness).map(([x, y]) => {
      const at = subtract(add(middle, add(scale(u, x), scale(v, y))), origin);
      return [dot(at, right), dot(at, up)];
    });
  }

  /** Says that vertices lie on a cylinder about an axis, or on a ball. */
  round(name: string, where: (at: Vec3) => boolean, axis?: Vec3): void {
    const vertices = this.#where(where);
    this.#rounds.push(axis ? { name, axis, vertices } : { name, vertices });
  }

  #where(test: (at: Vec3) => boolean): number[] {
    return this.#positions.flatMap((at, v) => (test(at) ? [v] : []));
  }

  /** The shape; ends that are flat are found, further sets are those that the tests let in. */
  shape(
    name: string,
    sets: Readonly<Record<string, (at: Vec3) => boolean>> = {},
    bevels: readonly string[] = [],
  ): Shape {
    const bounds = [0, 1, 2].map((axis) => this.#positions.map((p) => p[axis]!));
    const ends = ['left', 'right', 'front', 'back', 'bottom', 'top'].map((end, k) => {
      const values = bounds[k >> 1]!;
      const limit = k % 2 === 0 ? Math.min(...values) : Math.max(...values);
      return [end, this.#where((at) => Math.abs(at[k >> 1]! - limit) < 1e-6)] as const;
    });
    const named = Object.entries(sets).map(([set, test]) => [set, this.#where(test)] as const);
    return {
      name,
      positions: Float64Array.from(this.#positions.flat()),
      triangles: Uint32Array.from(this.#triangles),
      sets: Object.fromEntries([...ends, ...named]),
      rounds: this.#rounds,
      bevels,
    };
  }
}

/** Names of the cells, a millionth wide, that a point lies in or close to: its own first. */
function cellsAround(at: Vec3): string[] {
  const [xs, ys, zs] = at.map((x) => {
    const near = [1e6 * x, 1e6 * x + 0.3, 1e6 * x - 0.3].map((value) => Math.round(value) + 0);
    return near.filter((value, k) => near.indexOf(value) === k);
  }) as [number[], number[], number[]];
  return xs.flatMap((x) => ys.flatMap((y) => zs.map((z) => `${x} ${y} ${z}`)));
}

/** Points around a rectangle in the plane, its sides cut into pieces. */
export function gridRim(
  [left, right, columns]: readonly number[],
  [low, high, rows]: readonly number[],
): Loop {
  const along = (from: number, to: number, count: number) =>
    Array.from({ length: count }, (_, k) => from + ((to - from) * k) / count);
  return [
    ...along(left!, right!, columns!).map((x): Vec2 => [x, low!]),
    ...along(low!, high!, rows!).map((y): Vec2 => [right!, y]),
    ...along(right!, left!, columns!).map((x): Vec2 => [x, high!]),
    ...along(high!, low!, rows!).map((y): Vec2 => [left!, y]),
  ];
}

/** Two directions that are a right-handed frame with an axis. */
export function frame(axis: Vec3): [Vec3, Vec3] {
  const aside: Vec3 = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const u = unit(subtract(aside, scale(axis, dot(aside, axis))));
  return [u, cross(axis, u)];
}

const reversed = (stretch: Stretch): Stretch => ({ ...stretch, at: (share) => stretch.at(1 - share) });
