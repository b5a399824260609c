import type { NumberParameter } from '../../src/methods/values/number.ts';

/** Steps of a slider's travel. */
export const travel = 200;

/**
 * Where a value stands on the slider and back. A range that begins at nothing is travelled by the square, so that the small
 * values, where most of the looks are, have room.
 */
export function toTravel({ slider }: NumberParameter, value: number): number {
  const { min, max } = slider!;
  const share = Math.min(1, Math.max(0, (value - min) / (max - min)));
  return Math.round(travel * (min === 0 ? Math.sqrt(share) : share));
}

export function fromTravel({ slider, min: lowest, max: highest }: NumberParameter, stand: number): number {
  const { min, max, step } = slider!;
  const t = stand / travel;
  const exact = min + (max - min) * (min === 0 ? t * t : t);
  // Near nothing one stand of the slider is less than a step: as fine as the stand is wide, then.
  const width = min === 0 ? (2 * max * Math.max(t, 0.5 / travel)) / travel : step;
  const grain = Math.min(step, 10 ** Math.floor(Math.log10(width)));
  const value = Math.round(exact / grain) * grain;
  return Number(Math.min(highest, Math.max(lowest, value)).toPrecision(6));
}

/** As short as it can be said: 0.2, 1.35, 0.003. */
export function spoken(value: number): string {
  return String(Number(value.toPrecision(3)));
}
