import { counted } from './refuse.ts';

/** Vertices that have no place: a coordinate of theirs is not finite, and no face uses them. */
export interface Placeless {
  /** Their indices, rising; absent if there are none. */
  readonly placeless?: readonly number[];
  /** A sentence about them, if there are any. */
  readonly warnings: readonly string[];
}

/**
 * Finds what is not finite among positions. Nothing depends on a vertex that no face uses, so the file keeps what it has there,
 * and the mesh gets the middle of the others in its stead: finite, and in the way of no box.
 *
 * @param positions #P×3 as the file has them; becomes finite
 * @param corners indices of the vertices that faces use
 * @param refuse makes the error for a vertex that a face uses
 */
export function settlePlaceless(
  positions: Float64Array,
  corners: Uint32Array,
  refuse: (vertex: number) => Error,
): Placeless {
  const found = notFinite(positions);
  if (found.length === 0) return { warnings: [] };
  const used = new Uint8Array(positions.length / 3);
  for (const vertex of corners) used[vertex] = 1;
  const needed = found.find((vertex) => used[vertex] === 1);
  if (needed !== undefined) throw refuse(needed);
  const middle = middleOf(positions, used);
  for (const vertex of found) positions.set(middle, 3 * vertex);
  const what = counted(found.length, 'vertex that no face uses has', 'vertices that no face uses have');
  const stays = found.length === 1 ? 'it stays as it is' : 'they stay as they are';
  return { placeless: found, warnings: [`${what} coordinates that are no numbers; ${stays}.`] };
}

/** New positions that leave vertices without a place where they are. */
export function withPlaceless(
  { positions, placeless }: { readonly positions: Float64Array } & Pick<Placeless, 'placeless'>,
  after: Float64Array,
): Float64Array {
  if (!placeless) return after;
  const result = after.slice();
  for (const vertex of placeless) result.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * vertex);
  return result;
}

function notFinite(positions: Float64Array): number[] {
  const found: number[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    const sum = positions[i] - positions[i] + (positions[i + 1] - positions[i + 1]);
    if (sum + (positions[i + 2] - positions[i + 2]) !== 0) found.push(i / 3);
  }
  return found;
}

/** The middle of the box of all used vertices. */
function middleOf(positions: Float64Array, used: Uint8Array): number[] {
  return [0, 1, 2].map((axis) => {
    let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let v = 0; v < used.length; v++) {
      if (used[v] === 0) continue;
      low = Math.min(low, positions[3 * v + axis]);
      high = Math.max(high, positions[3 * v + axis]);
    }
    return low / 2 + high / 2;
  });
}
