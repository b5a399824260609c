import type { Stretching } from '../gestures.ts';
import type { Shape } from '../shape.ts';

/** The longest side of its box is lengthened, the middle one widened, the shortest raised, by what lies at its ends. */
export function foundGestures({ positions }: Shape): Record<string, Stretching> {
  const sides = (['x', 'y', 'z'] as const)
    .map((letter, axis) => ({ letter, size: sizeAlong(positions, axis) }))
    .toSorted((a, b) => b.size - a.size);
  const factors = [1.5, 1.4, 1.5];
  return Object.fromEntries(
    ['lengthen', 'widen', 'raise'].map((name, k) => {
      const { letter } = sides[k]!;
      return [name, { held: `${letter} low`, moved: `${letter} high`, factor: factors[k]! }];
    }),
  );
}

function sizeAlong(positions: Float64Array, axis: number): number {
  let [low, high] = [Infinity, -Infinity];
  for (let p = axis; p < positions.length; p += 3) {
    low = Math.min(low, positions[p]!);
    high = Math.max(high, positions[p]!);
  }
  return high - low;
}
