import type { Texture } from './texture.ts';

/**
 * A texture at every coarseness, each level half as wide and high as the one before down to a single pixel: the mean over a
 * footprint of any size in constant time.
 */
export class Pyramid {
  readonly levels: readonly Texture[];
  /** The steepness of each level, once it was asked for. */
  readonly #steepness: number[] = [];

  constructor(texture: Texture) {
    const levels = [texture];
    for (let last = texture; last.width > 1 || last.height > 1; levels.push(last)) last = halved(last);
    this.levels = levels;
  }

  /**
   * The mean slope around a place of the texture, which goes on beyond its edges; written to `into`.
   *
   * @param u to the right, v upward; 0 to 1 is the image once
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
    const place = Math.min(this.levels.length - 1, Math.max(0, Math.round(level)));
    this.#steepness[place] ??= steepnessOf(this.levels[place]!);
    return this.#steepness[place];
  }
}

function steepnessOf({ slopes }: Texture): number {
  let sum = 0;
  for (const slope of slopes) sum += slope * slope;
  return Math.sqrt((2 * sum) / slopes.length);
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
    for (let i = 0; i < across; i++) {
      let [u, v] = [0, 0];
      for (let row = rows.first[j]!; row <= rows.last[j]!; row++)
        for (let column = columns.first[i]!; column <= columns.last[i]!; column++) {
          const share = shareOf(rows, j, row) * shareOf(columns, i, column);
          const from = 2 * (row * width + column);
          u += share * slopes[from]!;
          v += share * slopes[from + 1]!;
        }
      result[2 * (j * across + i)] = u;
      result[2 * (j * across + i) + 1] = v;
    }
  return { width: across, height: down, slopes: result };
}

/** A line of many parts as one of few: which of the many each of the few covers, from the first to the last. */
interface Cover {
  /** Many over few. */
  readonly size: number;
  readonly first: Uint32Array;
  readonly last: Uint32Array;
}

function covers(many: number, few: number): Cover {
  const size = many / few;
  return {
    size,
    first: new Uint32Array(few).map((_, k) => Math.floor(k * size)),
    last: new Uint32Array(few).map((_, k) => Math.min(many, Math.ceil((k + 1) * size - 1e-9)) - 1),
  };
}

function shareOf({ size }: Cover, k: number, part: number): number {
  return (Math.min((k + 1) * size, part + 1) - Math.max(k * size, part)) / size;
}
