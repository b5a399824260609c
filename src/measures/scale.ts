/**
 * How values find their place on the band of colours: from 0 up to an end, to both sides of 0, or as factors to both sides of
 * 1. What lies beyond an end has its colour.
 */
export type Scale =
  | { readonly kind: 'rising'; readonly end: number; readonly unit: string }
  | { readonly kind: 'signed'; readonly end: number; readonly unit: string }
  | { readonly kind: 'factor'; readonly end: number };

/** The place of a value, from 0 to 1; NaN has none. */
export function shareOf(scale: Scale, value: number): number {
  return Math.max(0, Math.min(1, place(scale, value)));
}

function place({ kind, end }: Scale, value: number): number {
  if (kind === 'rising') return value / end;
  const side = kind === 'signed' ? value / end : Math.log(value) / Math.log(end);
  return (1 + side) / 2;
}

/** What stands below the band, from left to right, evenly. */
export function ticksOf(scale: Scale): readonly string[] {
  const { kind, end } = scale;
  if (kind === 'rising') return ['0', `${end}${scale.unit}`];
  if (kind === 'signed') return [`−${end}`, '0', `${end}${scale.unit}`];
  return [times(1 / end), '×1', times(end)];
}

/** The ends in words. */
export function rangeOf(scale: Scale): string {
  const ticks = ticksOf(scale);
  return `${ticks[0]} to ${ticks.at(-1)}`;
}

/** “×0.67” */
export function times(factor: number): string {
  return `×${Number(factor.toPrecision(2))}`;
}

/** How many values fall into each of some equal parts of the band; what lies beyond counts at the end, NaN nowhere. */
export function histogram(scale: Scale, values: Float32Array, parts: number): number[] {
  const counts = new Array<number>(parts).fill(0);
  for (const value of values) {
    const share = shareOf(scale, value);
    if (Number.isNaN(share)) continue;
    const part = Math.min(parts - 1, Math.floor(share * parts));
    counts[part] = counts[part]! + 1;
  }
  return counts;
}
