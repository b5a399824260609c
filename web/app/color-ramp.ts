import { Color } from 'three';
import { type Scale, shareOf } from '../../src/measures/scale.ts';

const colors = (...texts: string[]) => texts.map((text) => new Color(text));

/**
 * From little to much: dark blue over teal to pale yellow. Lightness only rises, and blue against yellow is told apart with
 * every common kind of colour blindness.
 */
const rising = colors('#27306e', '#2b5f94', '#2f8f95', '#63b97f', '#bcd86a', '#fbf3a6');

/** To both sides of a neutral middle: blue over paper white to rust. Both sides darken alike. */
const diverging = colors('#1f4e8c', '#4f8fc0', '#a9cbdc', '#f4efe6', '#eebb8d', '#d3753c', '#8f3410');

/** Where there is nothing to measure. */
export const blank = new Color('#8b8680');

const stopsOf = ({ kind }: Scale): readonly Color[] => (kind === 'rising' ? rising : diverging);

/** How strong a style is, from nothing to all: blue over paper to clay. */
const strength = colors('#3d6fb0', '#8fb0cf', '#e6dfd4', '#e3b28c', '#d5804f');
const strengthTable = Array.from(
  { length: 256 },
  (_, k) => between(strength, k / 255).toArray() as [number, number, number],
);

/** The linear colour of a strength from 0 to 1. */
export function strengthColor(share: number): readonly [number, number, number] {
  return strengthTable[Math.round(255 * share)]!;
}

/** As CSS: from no strength to all of it. */
export const strengthGradient = `linear-gradient(to right, ${strength.map((color) => color.getStyle()).join(', ')})`;

/** The colour of a share of the band, from 0 to 1. */
export function ramp(scale: Scale, share: number): Color {
  return between(stopsOf(scale), share);
}

function between(stops: readonly Color[], share: number): Color {
  const at = Math.max(0, Math.min(1, share)) * (stops.length - 1);
  const below = Math.min(stops.length - 2, Math.floor(at));
  return stops[below]!.clone().lerp(stops[below + 1]!, at - below);
}

/** As CSS: the whole band. */
export function gradient(scale: Scale): string {
  return `linear-gradient(to right, ${stopsOf(scale)
    .map((color) => color.getStyle())
    .join(', ')})`;
}

/** Linear colours for the viewer, #P×3. */
export function rampColors(scale: Scale, values: Float32Array): Float32Array<ArrayBuffer> {
  const table = Array.from({ length: 256 }, (_, k) => ramp(scale, k / 255).toArray());
  const none = blank.toArray();
  const painted = new Float32Array(3 * values.length);
  values.forEach((value, p) => {
    const share = shareOf(scale, value);
    painted.set(Number.isNaN(share) ? none : table[Math.round(255 * share)]!, 3 * p);
  });
  return painted;
}
