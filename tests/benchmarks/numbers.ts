/** The value at a share of the sorted values, between two of them by proportion. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const below = Math.floor(at);
  const next = Math.min(below + 1, sorted.length - 1);
  return sorted[below]! + (at - below) * (sorted[next]! - sorted[below]!);
}

export const median = (values: readonly number[]): number => quantile(values, 0.5);

/** “0.52 (0.50–0.55)”: the median and the quartiles. */
export function withSpread(values: readonly number[]): string {
  const [low, middle, high] = [0.25, 0.5, 0.75].map((share) => quantile(values, share).toFixed(2));
  return `${middle} (${low}–${high})`;
}

/** How far the farthest of some points (#P×3) is from where others have it. */
export function farthest(a: Float64Array, b: Float64Array): number {
  let most = 0;
  for (let i = 0; i < a.length; i += 3)
    most = Math.max(most, Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!));
  return most;
}

/** The diagonal of the box around points, #P×3. */
export function diagonalOf(positions: Float64Array): number {
  const [low, high] = [new Float64Array(3).fill(Infinity), new Float64Array(3).fill(-Infinity)];
  for (const [i, x] of positions.entries()) {
    low[i % 3] = Math.min(low[i % 3]!, x);
    high[i % 3] = Math.max(high[i % 3]!, x);
  }
  return Math.hypot(...high.map((most, axis) => most - low[axis]!));
}

/** “4.2×”, “23×”; a dash for what is no ratio. */
export function times(ratio: number): string {
  if (!(ratio > 0 && Number.isFinite(ratio))) return '–';
  return `${ratio < 10 ? ratio.toFixed(1) : ratio.toFixed(0)}×`;
}

/** 0.012 becomes “1.2 %”. */
export function percent(share: number): string {
  if (share < 0) return '–';
  if (share !== 0 && share < 1e-5) return '< 0.001 %';
  return `${Number((100 * share).toPrecision(2))} %`;
}

/** A duration in ms for a person: “0.66 ms”, “17 ms”, “2.8 s”. */
export function duration(milliseconds: number): string {
  if (milliseconds < 0) return '–';
  if (milliseconds >= 1000) return `${(milliseconds / 1000).toFixed(1)} s`;
  return `${Number(milliseconds.toPrecision(2))} ms`;
}

/** A table in Markdown, its columns aligned for those who read it as text. */
export function markdownTable(headers: readonly string[], rows: readonly (readonly string[])[]): string {
  const all = [headers, ...rows];
  const widths = headers.map((_, column) => Math.max(3, ...all.map((row) => row[column]!.length)));
  const line = (cells: readonly string[]): string =>
    `| ${cells.map((cell, column) => cell.padEnd(widths[column]!)).join(' | ')} |`;
  return [line(headers), line(widths.map((width) => '-'.repeat(width))), ...rows.map(line)].join('\n');
}
