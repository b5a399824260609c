import type { Vec3 } from '../../src/mesh/vectors.ts';
import { distance } from '../../src/mesh/vectors.ts';
import type { Fineness } from './fineness.ts';
import { isAround } from './flat.ts';
import { arc, type Stretch, straight } from './outline.ts';
import type { Vec2 } from './plane.ts';
import { revolve } from './revolved.ts';
import type { Shape } from './shape.ts';
import { Solid } from './solid.ts';

const up: Vec3 = [0, 0, 1];
const quarter = Math.PI / 2;

/** Straight stretches through points. */
const path = (...points: Vec2[]): Stretch[] => points.slice(1).map((to, k) => straight(points[k]!, to));

const isBetween = (low: number, high: number) => (at: Vec3) => at[2] > low - 1e-6 && at[2] < high + 1e-6;
const onCylinder = (radius: number, low: number, high: number) => (at: Vec3) =>
  isAround(up, radius)(at) && isBetween(low, high)(at);

/** Radius 1, length 4; its caps are flat. */
export function cylinder(fineness: Fineness, staggered = true): Shape {
  const solid = new Solid(fineness);
  const profile = path([0, 0], [1, 0], [1, 4], [0, 4]);
  revolve(solid, { profile, staggered });
  solid.round('side', isAround(up, 1), up);
  return solid.shape(staggered ? 'cylinder' : 'ruled cylinder');
}

/** Radius 0.5, length 4 with its round ends. */
export function capsule(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  revolve(solid, {
    profile: [
      arc([0, 0.5], 0.5, -quarter, 0),
      straight([0.5, 0.5], [0.5, 3.5]),
      arc([0, 3.5], 0.5, 0, quarter),
    ],
  });
  solid.round('side', onCylinder(0.5, 0.5, 3.5), up);
  return solid.shape('capsule', { 'low end': isBetween(0, 0.5), 'high end': isBetween(3.5, 4) });
}

/** Two balls of radius 0.6 on a rod of radius 0.2. */
export function dumbbell(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [ball, rod, height] = [0.6, 0.2, 3];
  const neck = Math.acos(rod / ball);
  const seam = ball * Math.sin(neck);
  revolve(solid, {
    profile: [
      arc([0, 0], ball, -quarter, neck),
      straight([rod, seam], [rod, height - seam]),
      arc([0, height], ball, -neck, quarter),
    ],
  });
  const onBall = (middle: number) => (at: Vec3) => Math.abs(distance(at, [0, 0, middle]) - ball) < 1e-6;
  solid.round('rod', onCylinder(rod, seam, height - seam), up);
  solid.round('low ball', onBall(0));
  solid.round('high ball', onBall(height));
  return solid.shape('dumbbell', { 'low ball': onBall(0), 'high ball': onBall(height) });
}

/** A disc, a rod and a shade, in one piece. */
export function lamp(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const profile = path(
    [0, 0],
    [0.8, 0],
    [0.8, 0.15],
    [0.1, 0.15],
    [0.1, 2.2],
    [0.9, 2.2],
    [0.55, 3.2],
    [0, 3.2],
  );
  revolve(solid, { profile });
  solid.round('rod', onCylinder(0.1, 0.15, 2.2), up);
  solid.round('base', onCylinder(0.8, 0, 0.15), up);
  return solid.shape('lamp', { base: isBetween(0, 0.15), shade: isBetween(2.2, 3.2) });
}

/** A foot, a stem and a hollow bowl. */
export function wineglass(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const [stem, bowl, wall, middle] = [0.09, 0.75, 0.07, 2.2];
  const joint = -Math.acos(stem / bowl);
  revolve(solid, {
    profile: [
      ...path([0, 0], [0.75, 0], [0.75, 0.06], [stem, 0.2], [stem, middle + bowl * Math.sin(joint)]),
      arc([0, middle], bowl, joint, 0.5),
      straight(arc([0, middle], bowl, 0, 0.5).at(1), arc([0, middle], bowl - wall, 0, 0.5).at(1)),
      arc([0, middle], bowl - wall, 0.5, -quarter),
    ],
  });
  solid.round('stem', onCylinder(stem, 0.2, middle + bowl * Math.sin(joint)), up);
  const inBowl = (at: Vec3) => distance(at, [0, 0, middle]) < bowl + 1e-6;
  return solid.shape('wineglass', { foot: isBetween(0, 0.06), bowl: inBowl });
}

/** Radius 1. */
export function ball(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  revolve(solid, { profile: [arc([0, 0], 1, -quarter, quarter)] });
  solid.round('ball', () => true);
  return solid.shape('ball');
}

/** The upper half of a ball of radius 1, a sheet that is open below. */
export function hemisphere(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  revolve(solid, { profile: [arc([0, 0], 1, 0, quarter)] });
  solid.round('ball', () => true);
  return solid.shape('hemisphere', { rim: isBetween(0, 0) });
}

/** A body, a shoulder and a neck, closed. */
export function bottle(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  const profile = [
    ...path([0, 0], [0.6, 0], [0.6, 1.8]),
    arc([0.2, 1.8], 0.4, 0, quarter),
    ...path([0.2, 2.2], [0.2, 3], [0, 3]),
  ];
  revolve(solid, { profile });
  solid.round('body', onCylinder(0.6, 0, 1.8), up);
  solid.round('neck', onCylinder(0.2, 2.2, 3), up);
  return solid.shape('bottle');
}

/** A ring: radius 1 of the middle line, 0.35 of the tube. */
export function ring(fineness: Fineness): Shape {
  const solid = new Solid(fineness);
  // Two halves, so that the number of rows is even and the last is the first.
  revolve(solid, { profile: [arc([1, 0], 0.35, -Math.PI, 0), arc([1, 0], 0.35, 0, Math.PI)] });
  return solid.shape('ring');
}
