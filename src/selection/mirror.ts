import { combined, nothing, type Selection, selectedVertices } from './selection.ts';
import { pieceLength, type Work } from './work.ts';

/** A plane across an axis of the file: x, y or z is 0, 1 or 2. */
export interface MirrorPlane {
  readonly axis: 0 | 1 | 2;
  /** Where it cuts the axis, in file units. */
  readonly offset: number;
}

/** Which vertex lies opposite each. */
export interface MirrorMap {
  readonly plane: MirrorPlane;
  /** #V; `alone` for a vertex with nobody on the other side. One in the plane is its own partner. */
  readonly partner: Uint32Array;
  /** How many have no partner. */
  readonly alone: number;
}

export const alone = 0xffffffff;

/** Of the diagonal of the box: so far from the mirror image of a vertex its partner may be. Sculptures are symmetric by eye. */
const tolerance = 2e-3;

/**
 * The partners of all vertices across the plane that a mesh is symmetric about, of the two that come into question: through the
 * middle of its box, or through the origin of its file.
 *
 * @param places #V×3 of the file's own shape: a shape that was pulled to one side is symmetric no more
 */
export function* mirrorMap(places: Float64Array, axis: MirrorPlane['axis']): Work<MirrorMap> {
  const box = boxOf(places);
  const middle = (box.low[axis]! + box.high[axis]!) / 2;
  const reach = tolerance * Math.hypot(...box.high.map((high, k) => high - box.low[k]!));
  const grid = new Grid(places, reach);
  yield;
  const best = yield* partners(places, grid, { axis, offset: middle });
  // The two planes are one.
  if (best.alone === 0 || Math.abs(middle) <= reach / 4) return best;
  const other = yield* partners(places, grid, { axis, offset: 0 });
  return other.alone < best.alone ? other : best;
}

/** The mirror image of a selection. */
export function mirrored(selection: Selection, { partner }: MirrorMap): Selection {
  const opposite = selectedVertices(selection).map((v) => partner[v]!);
  return combined(
    nothing(selection.marks.length),
    opposite.filter((v) => v !== alone),
    'replace',
  );
}

/** How many of the selected have nobody on the other side. */
export function aloneIn(selection: Selection, { partner }: MirrorMap): number {
  return selectedVertices(selection).reduce((count, v) => count + (partner[v] === alone ? 1 : 0), 0);
}

function* partners(places: Float64Array, grid: Grid, plane: MirrorPlane): Work<MirrorMap> {
  const partner = new Uint32Array(places.length / 3);
  let count = 0;
  const image: [number, number, number] = [0, 0, 0];
  for (let v = 0; v < partner.length; v++) {
    for (let k = 0; k < 3; k++) image[k] = places[3 * v + k]!;
    image[plane.axis] = 2 * plane.offset - image[plane.axis];
    const near = grid.nearest(image);
    partner[v] = near;
    if (near === alone) count++;
    if (v % (pieceLength / 8) === 0) yield;
  }
  return { plane, partner, alone: count };
}

function boxOf(places: Float64Array): { low: number[]; high: number[] } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i++) {
    low[i % 3] = Math.min(low[i % 3]!, places[i]!);
    high[i % 3] = Math.max(high[i % 3]!, places[i]!);
  }
  return { low, high };
}

/** Vertices by the cell of a grid that they lie in, cells hashed. */
class Grid {
  readonly #places: Float64Array;
  readonly #reach: number;
  /** Twice the reach, so that what is near lies in one of the eight cells on the sides that the place is nearer to. */
  readonly #size: number;
  readonly #mask: number;
  readonly #heads: Int32Array;
  readonly #next: Int32Array;

  constructor(places: Float64Array, reach: number) {
    const count = places.length / 3;
    this.#places = places;
    this.#reach = reach;
    this.#size = reach > 0 ? 2 * reach : 1;
    this.#mask = 2 ** Math.ceil(Math.log2(Math.max(2, 2 * count))) - 1;
    this.#heads = new Int32Array(this.#mask + 1).fill(-1);
    this.#next = new Int32Array(count);
    for (let v = 0; v < count; v++) {
      const bucket = this.#bucket(
        Math.floor(places[3 * v]! / this.#size),
        Math.floor(places[3 * v + 1]! / this.#size),
        Math.floor(places[3 * v + 2]! / this.#size),
      );
      this.#next[v] = this.#heads[bucket]!;
      this.#heads[bucket] = v;
    }
  }

  /** The vertex that is nearest to a place and no further than the reach; {@link alone} if there is none. */
  nearest([x, y, z]: readonly [number, number, number]): number {
    let found = alone;
    let least = this.#reach * this.#reach;
    const i = this.#first(x);
    const j = this.#first(y);
    const k = this.#first(z);
    for (let cell = 0; cell < 8; cell++) {
      const bucket = this.#bucket(i + (cell & 1), j + ((cell >> 1) & 1), k + (cell >> 2));
      for (let v = this.#heads[bucket]!; v >= 0; v = this.#next[v]!) {
        const square =
          (this.#places[3 * v]! - x) ** 2 +
          (this.#places[3 * v + 1]! - y) ** 2 +
          (this.#places[3 * v + 2]! - z) ** 2;
        if (square < least || (square === least && v < found)) [found, least] = [v, square];
      }
    }
    return found;
  }

  #first(x: number): number {
    return Math.floor(x / this.#size - 0.5);
  }

  #bucket(i: number, j: number, k: number): number {
    let hash = Math.imul(i, 0x9e3779b1);
    hash = Math.imul(hash ^ (hash >>> 15) ^ j, 0x85ebca6b);
    hash = Math.imul(hash ^ (hash >>> 13) ^ k, 0xc2b2ae35);
    return (hash ^ (hash >>> 16)) & this.#mask;
  }
}
