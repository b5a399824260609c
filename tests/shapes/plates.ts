import type { Vec3 } from '../../src/mesh/vectors.ts';
import { extrude } from './extruded.ts';
import type { Fineness } from './fineness.ts';
import { polygon, rectangle, rounded, sampled } from './outline.ts';
import type { Vec2 } from './plane.ts';
import type { Shape } from './shape.ts';
import { gridRim, Solid } from './solid.ts';

/** Puts what is drawn in (x, y) upright into (x, z), its depth backwards. */
const upright = ([x, y, z]: Vec3): Vec3 => [x, -z, y];

/** 4×2×0.4 with five holes of different sizes. */
export function drilledPlate(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const holes = (
    [
      [1, 1, 0.4],
      [2, 0.7, 0.3],
      [3, 1.2, 0.45],
      [2.2, 1.5, 0.2],
      [3.3, 0.4, 0.2],
    ] as const
  ).map(([x, y, radius], k) => ({ name: `hole ${k + 1}`, at: [x, y] as const, radius }));
  extrude(solid, { outline: rectangle(0, 0, 4, 2), low: 0, high: 0.4, holes });
  return solid.shape('drilled plate');
}

/** A prism of so many sides, 4 long and of radius 0.5, its ends flat. */
export function rod(fineness: Fineness, sides: number): Shape {
  const solid = new Solid(fineness);
  extrude(solid, { outline: regular(sides, 0.5), low: 0, high: 4 });
  return solid.shape(`rod of ${sides} sides`);
}

/** A hexagon of radius 1 with a bore. */
export function nut(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const holes = [{ name: 'bore', at: [0, 0] as const, radius: 0.5 }];
  extrude(solid, { outline: regular(6, 1), low: 0, high: 0.8, holes });
  return solid.shape('nut');
}

/** A handset: a bar with two ends that are bent down, its corners rounded. */
export function handset(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const outline = rounded([
    { at: [0, 0] },
    { at: [1, 0], fillet: 0.1 },
    { at: [1, 0.5], fillet: 0.25 },
    { at: [3, 0.5], fillet: 0.25 },
    { at: [3, 0], fillet: 0.1 },
    { at: [4, 0] },
    { at: [4, 1], fillet: 0.4 },
    { at: [0, 1], fillet: 0.4 },
  ]);
  extrude(solid, { outline, low: 0, high: 0.7, place: upright });
  return solid.shape('handset', {
    'left end': ([x]) => x < 0.4 + 1e-6,
    'right end': ([x]) => x > 3.6 - 1e-6,
  });
}

/** Two arms with a fillet of 0.4 between them; the long one has a hole. */
export function bracket(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const outline = rounded([
    { at: [0, 0] },
    { at: [3, 0] },
    { at: [3, 0.4] },
    { at: [0.4, 0.4], fillet: 0.4 },
    { at: [0.4, 2] },
    { at: [0, 2] },
  ]);
  const bore = { name: 'hole', from: [2, -0.7, 0] as Vec3, to: [2, -0.7, 0.4] as Vec3, radius: 0.35 };
  const below = solid.circle(bore, [0, 0, 0], [1, 0, 0], [0, -1, 0]);
  const above = solid.circle(bore, [3, 0, 0.4], [-1, 0, 0], [0, -1, 0]);
  const sideHoles = new Map([
    [0, [below]],
    [2, [above]],
  ]);
  extrude(solid, { outline, low: 0, high: 1.4, sideHoles, place: upright });
  solid.bore(bore);
  const isFillet = ([x, , z]: Vec3) =>
    Math.abs(Math.hypot(x - 0.8, z - 0.8) - 0.4) < 1e-6 && x < 0.8 + 1e-6 && z < 0.8 + 1e-6;
  solid.round('fillet', isFillet, [0, 1, 0]);
  return solid.shape('bracket');
}

/** A board of 4×2×0.3 with four pegs on it, of two heights. */
export function pegs(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const all = (
    [
      [0.8, 0.6, 0.9],
      [1.6, 1.4, 0.7],
      [2.5, 0.7, 0.9],
      [3.2, 1.3, 0.7],
    ] as const
  ).map(([x, y, top], k) => {
    return { name: `peg ${k + 1}`, from: [x, y, 0.3] as Vec3, to: [x, y, top] as Vec3, radius: 0.25 };
  });
  const flat =
    (height: number, sign: number) =>
    ([x, y]: Vec2): Vec3 => [sign * x, y, height];
  const outline = rectangle(0, 0, 4, 2);
  const rim = sampled(outline, fineness);
  const circle = (k: number) => solid.circle(all[k]!, [0, 0, 0], [1, 0, 0], [0, 1, 0]);
  solid.fill([rim, ...all.map((_, k) => circle(k))], flat(0.3, 1));
  solid.fill([rim.map(([x, y]): Vec2 => [-x, y]).toReversed()], flat(0, -1));
  solid.sides({ outline, low: 0, high: 0.3 });
  for (const [k, peg] of all.entries()) {
    solid.bore(peg, true);
    solid.fill([circle(k).toReversed()], flat(peg.to[2], 1));
  }
  return solid.shape('pegs on a board');
}

/** A sheet of 1×1 in the plane, open around. */
export function sheet(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const cells = fineness.line(1);
  solid.fill([gridRim([0, 1, cells], [0, 1, cells])], ([x, y]) => [x, y, 0]);
  return solid.shape('sheet');
}

function regular(sides: number, radius: number) {
  return polygon(
    ...Array.from({ length: sides }, (_, k): Vec2 => {
      const angle = (2 * Math.PI * k) / sides;
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    }),
  );
}
