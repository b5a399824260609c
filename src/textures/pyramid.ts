import type { Texture } from './texture.ts';

/**
 * A texture at every coarseness, each level half as wide and high as the one before down to a single pixel: the mean over a
 * footprint of any size in constant time.
 */
export class Pyramid {
  readonly levels: readonly Texture[];

  constructor(texture: Texture) {
    const levels = [texture];
    for (let last = texture; last.width > 1 || last.height > 1; levels.push(last)) last = halved(last);
    this.levels = levels;
  }

  /**
   * The mean slope around a place of the texture, which goes on beyond its edges; written to `into`.
   *
   * @param u to the right, v upward; 0 to 1 is the picture once
   * @param level log₂ of the footprint's side in pixels; below 0 there is nothing finer
   */
  sample(u: number, v: number, level: number, into: Float64Array): void {
    const last = this.levels.length - 1;
    const place = Math.min(last, Math.max(0, level));
    const fine = Math.floor(place);
    into.fill(0);
    addBilinear(this.levels[fine]!, u, v, 1 - (place - fine), into);
    if (place > fine) addBilinear(this.levels[fine + 1]!, u, v, place - fine, into);
  }

  /** How steep the texture is at a level, the root of the mean square. */
  steepness(level: number): number {
    const { slopes } = this.levels[Math.min(this.levels.length - 1, Math.max(0, Math.round(level)))]!;
    let sum = 0;
    for (const slope of slopes) sum += slope * slope;
    return Math.sqrt((2 * sum) / slopes.length);
  }
}

function addBilinear(
  { width, height, slopes }: Texture,
  u: number,
  v: number,
  share: number,
  into: Float64Array,
) {
  const x = (u - Math.floor(u)) * width - 0.5;
  const y = (1 - (v - Math.floor(v))) * height - 0.5;
  const [i, j] = [Math.floor(x), Math.floor(y)];
  for (let corner = 0; corner < 4; corner++) {
    const [di, dj] = [corner & 1, corner >> 1];
    const weight = share * (di ? x - i : 1 - (x - i)) * (dj ? y - j : 1 - (y - j));
    const at = 2 * (((j + dj + height) % height) * width + ((i + di + width) % width));
    into[0]! += weight * slopes[at]!;
    into[1]! += weight * slopes[at + 1]!;
  }
}

/** Half as many pixels each way; of odd sizes each new one takes its share of the pixels that it covers. */
function halved({ width, height, slopes }: Texture): Texture {
  const across = Math.max(1, width >> 1);
  const down = Math.max(1, height >> 1);
  const columns = covers(width, across);
  const rows = covers(height, down);
  const result = new Float32Array(2 * across * down);
  for (let j = 0; j < down; j++)
    for (let i = 0; i < across; i++)
      for (const [row, rowShare] of rows[j]!)
        for (const [column, columnShare] of columns[i]!) {
          const [to, from] = [2 * (j * across + i), 2 * (row * width + column)];
          result[to]! += rowShare * columnShare * slopes[from]!;
          result[to + 1]! += rowShare * columnShare * slopes[from + 1]!;
        }
  return { width: across, height: down, slopes: result };
}

/** For each of `few` equal parts of a line, which of `many` it covers, and how much of it each of them is. */
function covers(many: number, few: number): [part: number, share: number][][] {
  const size = many / few;
  return Array.from({ length: few }, (_, k) => {
    const [begin, end] = [k * size, (k + 1) * size];
    const parts: [number, number][] = [];
    for (let part = Math.floor(begin); part < end - 1e-9; part++)
      parts.push([part, (Math.min(end, part + 1) - Math.max(begin, part)) / size]);
    return parts;
  });
}
