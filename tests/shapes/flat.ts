import { add, cross, distance, dot, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { arc, polygon, sampled } from './outline.ts';
import type { Vec2 } from './plane.ts';
import type { Solid } from './solid.ts';

export interface Box {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** A flat face by its corners, counter-clockwise from outside. */
export function facet(solid: Solid, ...corners: Vec3[]): void {
  const [origin, next] = corners as [Vec3, Vec3];
  const right = unit(subtract(next, origin));
  const across = corners.map((corner) => cross(right, subtract(corner, origin)));
  const normal = unit(across.reduce((a, b) => (dot(a, a) > dot(b, b) ? a : b)));
  const up = cross(normal, right);
  const flat = corners.map((corner): Vec2 => {
    const off = subtract(corner, origin);
    return [dot(off, right), dot(off, up)];
  });
  solid.fill([sampled(polygon(...flat), solid.fineness)], ([x, y]) =>
    add(origin, add(scale(right, x), scale(up, y))),
  );
}

/** The outside of several boxes that touch or overlap; faces are cut where another box begins or ends. */
export function boxes(solid: Solid, all: readonly Box[], placed: (at: Vec3) => Vec3 = (at) => at): void {
  const cuts = [0, 1, 2].map((axis) =>
    [...new Set(all.flatMap(({ min, max }) => [min[axis]!, max[axis]!]))].sort((a, b) => a - b),
  );
  const isFull = (cell: readonly number[]) =>
    all.some(({ min, max }) =>
      cell.every(
        (k, axis) => cuts[axis]![k]! >= min[axis]! && (cuts[axis]![k + 1] ?? Infinity) <= max[axis]!,
      ),
    );
  const [nx, ny, nz] = cuts.map((values) => values.length) as [number, number, number];
  for (let x = 0; x < nx; x++)
    for (let y = 0; y < ny; y++)
      for (let z = 0; z < nz; z++)
        for (const axis of [0, 1, 2]) {
          const [cell, before] = [
            [x, y, z],
            [x, y, z],
          ];
          before[axis]! -= 1;
          if (isFull(cell) !== isFull(before))
            cellFace(solid, { cuts, cell, axis, up: isFull(before) }, placed);
        }
}

interface CellFace {
  readonly cuts: readonly (readonly number[])[];
  readonly cell: readonly number[];
  readonly axis: number;
  /** Whether the outside is towards larger coordinates. */
  readonly up: boolean;
}

function cellFace(solid: Solid, { cuts, cell, axis, up }: CellFace, placed: (at: Vec3) => Vec3): void {
  const [b, c] = up ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
  const corner = (u: number, v: number): Vec3 => {
    const at: [number, number, number] = [0, 0, 0];
    at[axis] = cuts[axis]![cell[axis]!]!;
    at[b!] = cuts[b!]![cell[b!]! + u]!;
    at[c!] = cuts[c!]![cell[c!]! + v]!;
    return placed(at);
  };
  facet(solid, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
}

/** A box about the origin with edges cut off at 45°, or rounded. */
export function softenedBox(solid: Solid, half: Vec3, edge: { bevel: number } | { fillet: number }): void {
  const cut = 'bevel' in edge ? edge.bevel : edge.fillet;
  const at = (axis: number, along: number, second: number, third: number): Vec3 => {
    const p: [number, number, number] = [0, 0, 0];
    p[axis] = along;
    p[(axis + 1) % 3] = second;
    p[(axis + 2) % 3] = third;
    return p;
  };
  for (const axis of [0, 1, 2]) {
    const [h, b, c] = [half[axis]!, half[(axis + 1) % 3]!, half[(axis + 2) % 3]!];
    const [bi, ci] = [b - cut, c - cut];
    facet(solid, at(axis, h, -bi, -ci), at(axis, h, bi, -ci), at(axis, h, bi, ci), at(axis, h, -bi, ci));
    facet(solid, at(axis, -h, -bi, -ci), at(axis, -h, -bi, ci), at(axis, -h, bi, ci), at(axis, -h, bi, -ci));
    const quarters = [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ] as const;
    for (const [quarter, [sb, sc]] of quarters.entries()) {
      const from = (quarter * Math.PI) / 2;
      if ('fillet' in edge) {
        const outline = [arc([sb * bi, sc * ci], cut, from, from + Math.PI / 2)];
        solid.sides({ outline, low: cut - h, high: h - cut }, ([x, y, z]) => at(axis, z, x, y));
        continue;
      }
      const [p, q] =
        quarter % 2 === 0
          ? [
              [sb * b, sc * ci],
              [sb * bi, sc * c],
            ]
          : [
              [sb * bi, sc * c],
              [sb * b, sc * ci],
            ];
      const [low, high] = [cut - h, h - cut];
      const corner = (along: number, [x, y]: readonly number[]) => at(axis, along, x!, y!);
      facet(solid, corner(low, p!), corner(low, q!), corner(high, q!), corner(high, p!));
    }
  }
  for (const sx of [-1, 1])
    for (const sy of [-1, 1])
      for (const sz of [-1, 1]) corner(solid, half, cut, [sx, sy, sz], 'fillet' in edge);
}

/** The triangle, flat or an eighth of a ball, in a corner of a box. */
function corner(solid: Solid, half: Vec3, cut: number, signs: Vec3, isRound: boolean): void {
  const inner = half.map((h, axis) => signs[axis]! * (h - cut)) as unknown as Vec3;
  const tip = (direction: readonly number[]): Vec3 =>
    inner.map((x, axis) => x + cut * signs[axis]! * direction[axis]!) as unknown as Vec3;
  const isMirrored = signs[0] * signs[1] * signs[2] < 0;
  if (!isRound) {
    const corners = [tip([1, 0, 0]), tip([0, 1, 0]), tip([0, 0, 1])];
    facet(solid, ...(isMirrored ? corners.reverse() : corners));
    return;
  }
  const n = solid.fineness.arc(cut, Math.PI / 2);
  const vertex = (i: number, j: number): number => {
    const direction = [i, j, n - i - j].map((k) => Math.sin((k * Math.PI) / (2 * n)));
    const size = Math.hypot(...direction);
    return solid.vertex(tip(direction.map((x) => x / size)));
  };
  const triangle = (a: number, b: number, c: number) =>
    isMirrored ? solid.triangle(a, c, b) : solid.triangle(a, b, c);
  for (let i = 0; i < n; i++)
    for (let j = 0; i + j < n; j++) {
      triangle(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
      if (i + j + 1 < n) triangle(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
}

/** Whether a point is so far from an axis through the origin. */
export const isAround =
  (axis: Vec3, radius: number) =>
  (at: Vec3): boolean =>
    Math.abs(distance(at, scale(axis, dot(at, axis))) - radius) < 1e-6;
