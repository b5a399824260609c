import type { Vec3 } from '../../src/mesh/vectors.ts';
import type { Fineness } from './fineness.ts';
import { type Box, boxes, softenedBox } from './flat.ts';
import type { Shape } from './shape.ts';
import { assembled } from './shape.ts';
import { Solid } from './solid.ts';

const box = (
  x: readonly [number, number],
  y: readonly [number, number],
  z: readonly [number, number],
): Box => ({
  min: [x[0], y[0], z[0]],
  max: [x[1], y[1], z[1]],
});

/** Four legs at the corners of a square of a side. */
const legs = (side: number, width: number, height: number): Box[] =>
  [0, side - width].flatMap((x) =>
    [0, side - width].map((y) => box([x, x + width], [y, y + width], [0, height])),
  );

export function block(
  fineness: Fineness,
  x: readonly [number, number],
  y: readonly [number, number],
  z: readonly [number, number],
): Shape {
  const solid = new Solid(fineness);
  boxes(solid, [box(x, y, z)]);
  return solid.shape('block');
}

export function angle(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  boxes(solid, [box([0, 3], [0, 1], [0, 0.5]), box([0, 0.5], [0, 1], [0, 2.5])]);
  return solid.shape('angle');
}

export function table(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  boxes(solid, [box([0, 3], [0, 3], [1.8, 2.1]), ...legs(3, 0.35, 1.8)]);
  return solid.shape('table');
}

/** Legs that spread and a back that leans. */
export function chair(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [seat, top] = [1.5, 1.75];
  const parts = [
    box([0, 1.8], [0, 1.8], [seat, top]),
    ...legs(1.8, 0.3, seat),
    box([0, 0.25], [0, 1.8], [top, 3.4]),
  ];
  boxes(solid, parts, ([x, y, z]): Vec3 => {
    const spread = 0.12 * Math.max(0, seat - z);
    const lean = 0.25 * Math.max(0, z - top);
    return [x + spread * (x - 0.9) - lean, y + spread * (y - 0.9), z];
  });
  const leg =
    (sx: number, sy: number) =>
    ([x, y, z]: Vec3) =>
      z < 1e-6 && sx * (x - 0.9) > 0 && sy * (y - 0.9) > 0;
  return solid.shape('chair', {
    'front feet': (at) => leg(1, 1)(at) || leg(1, -1)(at),
    'back feet': (at) => leg(-1, 1)(at) || leg(-1, -1)(at),
    seat: ([, , z]) => z > seat - 1e-6 && z < top + 1e-6,
  });
}

/** 3×1.5×1, its edges cut off at 45°. */
export function chamferedBox(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [half, bevel]: [Vec3, number] = [[1.5, 0.75, 0.5], 0.12];
  softenedBox(solid, half, { bevel });
  const bevels: Record<string, (at: Vec3) => boolean> = {};
  for (const [sy, y] of [
    [-1, 'front'],
    [1, 'back'],
  ] as const)
    for (const [sz, z] of [
      [-1, 'bottom'],
      [1, 'top'],
    ] as const) {
      bevels[`bevel ${y} ${z}`] = (at) =>
        Math.abs(sy * at[1] + sz * at[2] - (half[1] + half[2] - bevel)) < 1e-6 &&
        Math.abs(at[0]) < half[0] - bevel + 1e-6;
    }
  return solid.shape('chamfered box', bevels, Object.keys(bevels));
}

/** 3×1.5×1, its edges and corners rounded. */
export function roundedBox(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [half, fillet]: [Vec3, number] = [[1.5, 0.75, 0.5], 0.25];
  softenedBox(solid, half, { fillet });
  for (const sy of [-1, 1])
    for (const sz of [-1, 1]) {
      const onEdge = ([x, y, z]: Vec3) =>
        Math.abs(x) < half[0] - fillet + 1e-6 &&
        sy * y > half[1] - fillet - 1e-6 &&
        sz * z > half[2] - fillet - 1e-6;
      solid.round(`edge ${sy} ${sz}`, onEdge, [1, 0, 0]);
    }
  return solid.shape('rounded box');
}

/** A block on a slab: touching, sunk into it or above it by so much. */
export function blockOnSlab(fineness: Fineness, above: number): Shape {
  return assembled(`block on a slab, ${above === 0 ? 'touching' : above > 0 ? 'with a gap' : 'sunk'}`, {
    slab: block(fineness, [0, 4], [0, 1.5], [0, 0.4]),
    block: block(fineness, [1.4, 2.6], [0.3, 1.2], [0.4 + above, 1.2 + above]),
  });
}
