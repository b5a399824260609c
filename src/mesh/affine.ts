import { add, cross, dot, scale, subtract, type Vec3 } from './vectors.ts';

/** A movement of space that keeps straight lines: x ↦ A x + b, with A by its rows. */
export interface Affine {
  readonly rows: readonly [Vec3, Vec3, Vec3];
  readonly offset: Vec3;
}

const axes: Affine['rows'] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

export function applied({ rows, offset }: Affine, point: Vec3): Vec3 {
  return add([dot(rows[0], point), dot(rows[1], point), dot(rows[2], point)], offset);
}

export function translation(by: Vec3): Affine {
  return { rows: axes, offset: by };
}

/** @param axis unit   @param angle in radians, counter-clockwise seen from the axis's tip */
export function rotationAbout(pivot: Vec3, axis: Vec3, angle: number): Affine {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const turned = (v: Vec3): Vec3 =>
    add(add(scale(v, c), scale(cross(axis, v), s)), scale(axis, dot(axis, v) * (1 - c)));
  const [x, y, z] = [turned(axes[0]), turned(axes[1]), turned(axes[2])];
  return fixing(pivot, [
    [x[0], y[0], z[0]],
    [x[1], y[1], z[1]],
    [x[2], y[2], z[2]],
  ]);
}

/** Stretches from a point, along an axis (unit) only if there is one. */
export function scalingFrom(pivot: Vec3, factor: number, axis: Vec3 | null): Affine {
  const row = (k: 0 | 1 | 2): Vec3 =>
    axis ? add(axes[k], scale(axis, (factor - 1) * axis[k])) : scale(axes[k], factor);
  return fixing(pivot, [row(0), row(1), row(2)]);
}

/** What a movement is on the other side of a mirror. @param axis the mirror stands across it, at `at` */
export function mirrored({ rows, offset }: Affine, axis: 0 | 1 | 2, at: number): Affine {
  const sign = (k: number) => (k === axis ? -1 : 1);
  const flipped = rows.map((row, r) => row.map((value, c) => value * sign(r) * sign(c))) as unknown as [
    Vec3,
    Vec3,
    Vec3,
  ];
  // In the mirror's frame, where it stands at 0, only the sign of the offset along its axis changes.
  const shift: Vec3 = [axis === 0 ? at : 0, axis === 1 ? at : 0, axis === 2 ? at : 0];
  const inside = subtract(applied({ rows, offset }, shift), shift).map((value, k) => value * sign(k));
  return {
    rows: flipped,
    offset: subtract(
      add(inside as unknown as Vec3, shift),
      applied({ rows: flipped, offset: [0, 0, 0] }, shift),
    ),
  };
}

function fixing(pivot: Vec3, rows: Affine['rows']): Affine {
  const moved: Vec3 = [dot(rows[0], pivot), dot(rows[1], pivot), dot(rows[2], pivot)];
  return { rows, offset: subtract(pivot, moved) };
}
