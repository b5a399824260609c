import { Color } from 'three';

/**
 * From little to much: dark blue over teal to pale yellow. Lightness only rises, and blue against yellow is told apart with
 * every common kind of colour blindness.
 */
const stops = ['#27306e', '#2b5f94', '#2f8f95', '#63b97f', '#bcd86a', '#fbf3a6'].map(
  (text) => new Color(text),
);

/** The colour of a share from 0 to 1. */
export function ramp(share: number): Color {
  const at = Math.max(0, Math.min(1, share)) * (stops.length - 1);
  const below = Math.min(stops.length - 2, Math.floor(at));
  return stops[below]!.clone().lerp(stops[below + 1]!, at - below);
}

/** As CSS: a band of the whole ramp. */
export const rampGradient = `linear-gradient(to right, ${stops.map((color) => color.getStyle()).join(', ')})`;

/** Linear colours for the viewer, #P×3. */
export function rampColors(values: Float32Array, max: number): Float32Array<ArrayBuffer> {
  const table = Array.from({ length: 256 }, (_, k) => ramp(k / 255).toArray());
  const colors = new Float32Array(3 * values.length);
  for (let p = 0; p < values.length; p++)
    colors.set(table[Math.round(255 * Math.max(0, Math.min(1, values[p]! / max)))]!, 3 * p);
  return colors;
}

/** How many values fall into each of some equal parts from 0 to `max`; what lies beyond counts in the last. */
export function histogram(values: Float32Array, max: number, parts: number): number[] {
  const counts = new Array<number>(parts).fill(0);
  for (const value of values) {
    const part = Math.max(0, Math.min(parts - 1, Math.floor((value / max) * parts)));
    counts[part] = counts[part]! + 1;
  }
  return counts;
}
