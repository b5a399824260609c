import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import type { Handles, HandlesParameter } from '../../src/methods/values/handles.ts';
import { checkValue, encodeValue } from '../../src/methods/values/index.ts';

const landmarks: HandlesParameter = {
  name: 'landmarks',
  kind: 'handles',
  label: 'Landmarks',
  doc: 'Vertices and where they are to go.',
  invalidates: 'system',
};

/** A strip of two squares whose middle edge the file stores twice: positions 1 and 4 are one place, and 2 and 7. */
const strip: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
};
const weld = weldOf(strip);
const v = (position: number) => weld.vertexOfPosition[position]!;

const problem = (value: unknown) => checkValue(landmarks, value)?.message;
const encoded = (value: Handles) => encodeValue(landmarks, value, weld);

describe('handles with vertices that stay', () => {
  it('have these last, without numbers, each place once', () => {
    const { numbers, indices } = encoded({ vertices: [5], targets: [[3, 0, 0]], fixed: [0, 1, 4] });
    expect([...numbers]).toEqual([3, 0, 0]);
    expect([...indices]).toEqual([v(5), v(0), v(1)]);
    expect([...encoded({ vertices: [], targets: [], fixed: [6] }).indices]).toEqual([v(6)]);
  });

  it('refuse a vertex that has a target as well, in one place of the file or in two', () => {
    const moved = { vertices: [1], targets: [[3, 0, 0]] } as const;
    expect(() => encoded({ ...moved, fixed: [1] })).toThrow(
      /gives vertex 1 a target and has it under “fixed” too/,
    );
    expect(() => encoded({ ...moved, fixed: [4] })).toThrow(
      /gives vertex 1 a target and has vertex 4 under “fixed”/,
    );
  });

  it('refuse what names no vertex', () => {
    expect(() => encoded({ vertices: [], targets: [], fixed: [8] })).toThrow(
      /names vertex 8, but the file has 8/,
    );
    expect(problem({ vertices: [], targets: [], fixed: 3 })).toMatch(/"fixed": \[index, …\]\}, not 3/);
    expect(problem({ vertices: [], targets: [], fixed: [0.5] })).toMatch(/entry 0 of “fixed” is 0\.5/);
    expect(problem({ vertices: [0], targets: [[0, 0, 0]], fixed: [1] })).toBeUndefined();
  });
});
