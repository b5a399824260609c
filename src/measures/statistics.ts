/** The mean of some values; NaN counts as none, and of none it is 0. */
export function mean(values: ArrayLike<number>): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < values.length; i++) {
    const value = values[i]!;
    if (Number.isNaN(value)) continue;
    sum += value;
    count++;
  }
  return count > 0 ? sum / count : 0;
}

/** The value that a share of all do not exceed; NaN counts as none, and of none it is 0. */
export function quantile(values: ArrayLike<number>, share: number): number {
  // Sorted numbers have NaN last.
  const sorted = Float64Array.from(values).sort();
  let count = sorted.length;
  while (count > 0 && Number.isNaN(sorted[count - 1]!)) count--;
  return count > 0 ? sorted[Math.floor(share * (count - 1))]! : 0;
}

/** The next number up that is easy to read: of two digits at most, and few of those. */
export function roundedUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit =
    [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((candidate) => candidate * power >= value * (1 - 1e-9)) ?? 10;
  return Number((digit * power).toPrecision(2));
}

/** “43 %” */
export function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}
