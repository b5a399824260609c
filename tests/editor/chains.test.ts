import { describe, expect, it } from 'vitest';
import { hasChain, withChain, withoutChain } from '../../src/editor/chains.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';

/** A strip of two squares whose middle edge the file stores twice: positions 1 and 4 are one place, and 2 and 7. */
const strip: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
};

describe('marked lines', () => {
  it('have each edge once, whichever way it goes and whatever the file calls its ends', () => {
    const first = withChain([], strip, [0, 1, 5]);
    expect(first).toEqual([[0, 1, 5]]);
    expect(withChain(first, strip, [5, 4, 0])).toEqual([[5, 4, 0]]);
    expect(withChain([[0, 1, 2, 3]], strip, [4, 7])).toEqual([
      [0, 1],
      [2, 3],
      [4, 7],
    ]);
  });

  it('are cut where a line in the middle is taken out, and stay the very same where it touches none', () => {
    const lines = [[3, 0, 1, 5, 6, 2, 3]];
    expect(withoutChain(lines, strip, [1, 5])).toEqual([
      [3, 0, 1],
      [5, 6, 2, 3],
    ]);
    expect(withoutChain(lines, strip, [1, 2])).toBe(lines);
    expect(withoutChain(lines, strip, lines[0]!)).toEqual([]);
  });

  it('tell whether all of a line is theirs', () => {
    const lines = [
      [0, 1],
      [4, 5],
    ];
    expect(hasChain(lines, strip, [5, 1, 0])).toBe(true);
    expect(hasChain(lines, strip, [0, 1, 2])).toBe(false);
  });
});
