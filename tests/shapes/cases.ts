import { angle, blockOnSlab, chair, chamferedBox, roundedBox, table } from './box-shapes.ts';
import { even, type Fineness, raw } from './fineness.ts';
import type { Stretching } from './gestures.ts';
import { bolt, mug, pinInHole } from './joined.ts';
import { bracket, drilledPlate, handset, nut, pegs, rod } from './plates.ts';
import {
  ball,
  bottle,
  capsule,
  cylinder,
  dumbbell,
  hemisphere,
  lamp,
  ring,
  wineglass,
} from './round-shapes.ts';
import type { Shape } from './shape.ts';

/** A shape and what a person may want of it. */
export interface Case {
  readonly name: string;
  readonly make: (fineness: Fineness) => Shape;
  /** The longest side of its box, in its own units. */
  readonly size: number;
  readonly gestures: Readonly<Record<string, Stretching>>;
  /** Whether it is made from outlines, so that there is a version as programs for construction write it. */
  readonly isDrawn?: boolean;
  /** Whether its round parts are to grow by the factor of a gesture, and else to stay. */
  readonly grows?: boolean;
}

/** Lengthened and shortened along x by its flat ends, widened along y, raised along z. */
const alongAxes = (factor: number): Record<string, Stretching> => ({
  lengthen: { held: 'left', moved: 'right', factor },
  shorten: { held: 'left', moved: 'right', factor: 0.5 },
  widen: { held: 'front', moved: 'back', factor: 1.4 },
  raise: { held: 'bottom', moved: 'top', factor: 1.5 },
});

/** Along z, by whole ends and by the points in the middle of them. */
const upright: Record<string, Stretching> = {
  lengthen: { held: 'bottom', moved: 'top', factor: 1.6 },
  'lengthen by points': { held: 'bottom', moved: 'top', factor: 1.6, points: true },
  shorten: { held: 'bottom', moved: 'top', factor: 0.5 },
};

/** The classic shapes, and those with holes, bevels and fillets. */
export const cases: readonly Case[] = [
  { name: 'cylinder', make: cylinder, size: 4, gestures: upright, isDrawn: true },
  { name: 'ruled cylinder', make: (fineness) => cylinder(fineness, false), size: 4, gestures: upright },
  {
    name: 'capsule',
    make: capsule,
    size: 4,
    gestures: {
      lengthen: { held: 'low end', moved: 'high end', factor: 1.6 },
      'lengthen by points': { held: 'bottom', moved: 'top', factor: 1.6, points: true },
    },
  },
  {
    name: 'dumbbell',
    make: dumbbell,
    size: 4.2,
    gestures: {
      lengthen: { held: 'low ball', moved: 'high ball', factor: 1.6 },
      'lengthen by points': { held: 'bottom', moved: 'top', factor: 1.6, points: true },
    },
  },
  { name: 'angle', make: angle, size: 3, gestures: alongAxes(1.6) },
  {
    name: 'table',
    make: table,
    size: 3,
    gestures: {
      raise: { held: 'bottom', moved: 'top', factor: 1.5 },
      widen: { held: 'front', moved: 'back', factor: 1.5 },
    },
  },
  {
    name: 'lamp',
    make: lamp,
    size: 3.2,
    gestures: {
      raise: { held: 'base', moved: 'shade', factor: 1.5 },
      'raise by points': { held: 'bottom', moved: 'top', factor: 1.5, points: true },
    },
  },
  {
    name: 'wineglass',
    make: wineglass,
    size: 2.6,
    gestures: {
      raise: { held: 'foot', moved: 'bowl', factor: 1.5 },
      'raise by points': { held: 'bottom', moved: 'top', factor: 1.4, points: true },
    },
  },
  {
    name: 'handset',
    make: handset,
    size: 4,
    gestures: {
      lengthen: { held: 'left end', moved: 'right end', factor: 1.6 },
      shorten: { held: 'left end', moved: 'right end', factor: 0.6 },
    },
    isDrawn: true,
  },
  {
    name: 'ball',
    make: ball,
    size: 2,
    gestures: { pull: { held: 'bottom', moved: 'top', factor: 1.5, points: true } },
    grows: true,
  },
  {
    name: 'hemisphere',
    make: hemisphere,
    size: 2,
    gestures: { pull: { held: 'left', moved: 'right', factor: 1.4, points: true } },
    grows: true,
  },
  {
    name: 'drilled plate',
    make: drilledPlate,
    size: 4,
    gestures: { ...alongAxes(1.6), 'shorten by 75 %': { held: 'left', moved: 'right', factor: 0.25 } },
    isDrawn: true,
  },
  {
    name: 'chamfered box',
    make: chamferedBox,
    size: 3,
    gestures: { ...alongAxes(1.6), 'shorten by 75 %': { held: 'left', moved: 'right', factor: 0.25 } },
    isDrawn: true,
  },
  { name: 'rounded box', make: roundedBox, size: 3, gestures: alongAxes(1.6), isDrawn: true },
  { name: 'bracket', make: bracket, size: 3, gestures: alongAxes(1.6), isDrawn: true },
  { name: 'pegs on a board', make: pegs, size: 4, gestures: alongAxes(1.6), isDrawn: true },
  {
    name: 'nut',
    make: nut,
    size: 2,
    gestures: {
      widen: { held: 'front', moved: 'back', factor: 1.4 },
      raise: { held: 'bottom', moved: 'top', factor: 1.5 },
    },
    isDrawn: true,
  },
  {
    name: 'bolt',
    make: bolt,
    size: 3.6,
    gestures: { lengthen: { held: 'head', moved: 'top', factor: 1.6 } },
    isDrawn: true,
  },
  {
    name: 'mug',
    make: mug,
    size: 2.7,
    gestures: {
      raise: { held: 'bottom', moved: 'top', factor: 1.6 },
      lower: { held: 'bottom', moved: 'top', factor: 0.6 },
    },
  },
  {
    name: 'bottle',
    make: bottle,
    size: 3,
    gestures: {
      raise: { held: 'bottom', moved: 'top', factor: 1.6 },
      lower: { held: 'bottom', moved: 'top', factor: 0.5 },
    },
    isDrawn: true,
  },
  {
    name: 'chair',
    make: chair,
    size: 3.4,
    gestures: {
      raise: { held: 'bottom', moved: 'top', factor: 1.4 },
      widen: { held: 'front', moved: 'back', factor: 1.4 },
    },
    isDrawn: true,
  },
  ...[0, 0.003].map((gap) => ({
    name: gap === 0 ? 'pin in a hole' : 'pin in a hole, with a gap',
    make: (fineness: Fineness) => pinInHole(fineness, gap),
    size: 4,
    gestures: { lengthen: { held: 'plate left', moved: 'plate right', factor: 1.6 } },
    isDrawn: true,
  })),
  ...[0, -0.1, 0.1].map((above) => ({
    name: `block on a slab, ${above === 0 ? 'touching' : above > 0 ? 'with a gap' : 'sunk'}`,
    make: (fineness: Fineness) => blockOnSlab(fineness, above),
    size: 4,
    gestures: { lengthen: { held: 'slab left', moved: 'slab right', factor: 1.6 } },
    isDrawn: true,
  })),
  ...[5, 6, 8, 12].map((sides) => ({
    name: `rod of ${sides} sides`,
    make: (fineness: Fineness) => rod(fineness, sides),
    size: 4,
    gestures: { lengthen: upright.lengthen!, 'lengthen by points': upright['lengthen by points']! },
    isDrawn: true,
  })),
  {
    name: 'ring',
    make: ring,
    size: 2.7,
    gestures: { pull: { held: 'left', moved: 'right', factor: 1.5, points: true } },
    grows: true,
  },
];

/** A case at a scale of its mesh: edges are so many times the 36th part of its longest side. */
export const meshed = ({ make, size }: Case, scale = 1): Shape => make(even(0.028 * scale * size));

/** A case as programs for construction write it. */
export const asDrawn = ({ make }: Case): Shape => make(raw());

/** A case by its name. */
export function caseOf(name: string): Case {
  const found = cases.find((candidate) => candidate.name === name);
  if (!found)
    throw new Error(`There is no “${name}”; there are ${cases.map(({ name }) => name).join(', ')}.`);
  return found;
}
