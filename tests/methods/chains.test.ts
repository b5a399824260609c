import { describe, expect, it } from 'vitest';
import { toFailure } from '../../src/mesh/failure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import type { Chains, ChainsParameter } from '../../src/methods/values/chains.ts';
import { checkValue, encodeValue, namesFile, valueHelp } from '../../src/methods/values/index.ts';

const straight: ChainsParameter = {
  name: 'straight',
  kind: 'chains',
  role: 'straight',
  label: 'Straight lines',
  doc: 'Lines that stay straight.',
  invalidates: 'system',
};

/** A strip of two squares whose middle edge the file stores twice: positions 1 and 4 are one place, and 2 and 7. */
const strip: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
};

const problem = (value: unknown) => checkValue(straight, value)?.message;
const encoded = (value: Chains) => encodeValue(straight, value, weldOf(strip));

describe('chains', () => {
  it('are laid out line by line, how many vertices and these, by their number in the welded mesh', () => {
    const { vertexOfPosition } = weldOf(strip);
    const v = (position: number) => vertexOfPosition[position]!;
    const { name, numbers, indices } = encoded([
      [0, 1, 5],
      [7, 1],
    ]);
    expect([name, [...numbers], [...indices]]).toEqual(['', [], [3, v(0), v(1), v(5), 2, v(2), v(4)]]);
  });

  it('meet a place that the file stores twice once, and what is left of one vertex is no line', () => {
    expect([...encoded([[0, 1, 4, 5]]).indices]).toEqual([...encoded([[0, 1, 5]]).indices]);
    expect([...encoded([[1, 4]]).indices]).toEqual([]);
    // One that comes back to where it began keeps its end.
    expect(encoded([[0, 1, 2, 3, 0]]).indices[0]).toBe(5);
  });

  it('refuse vertices that the file has not, by their own number', () => {
    let thrown: unknown;
    try {
      encoded([
        [0, 1],
        [2, 8],
      ]);
    } catch (error) {
      thrown = error;
    }
    const { code, message, element } = toFailure(thrown);
    expect([code, element]).toEqual(['bad-parameter', 8]);
    expect(message).toBe('“straight” names vertex 8 in line 1, but the file has 8 vertices (0 to 7).');
  });

  it('say what is wrong with a value', () => {
    expect(problem([])).toBeUndefined();
    expect(problem([[0, 1, 2]])).toBeUndefined();
    expect(problem({ vertices: [1] })).toMatch(/^“straight” must be \[\[vertex, vertex, …\], …\], not \{/);
    expect(problem([0, 1])).toMatch(/line 0 is 0\.$/);
    expect(problem([[0, 1], [2]])).toMatch(/two vertices or more; line 1 is \[2\]\.$/);
    expect(problem([[0, -1]])).toMatch(/whole numbers from 0; entry 1 of line 0 is -1\.$/);
  });

  it('are given to the command line as a file', () => {
    expect(namesFile(straight, 'lines.json')).toBe(true);
    expect(valueHelp(straight).value).toBe('FILE.json');
  });
});
