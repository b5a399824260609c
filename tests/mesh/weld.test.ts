import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { gather, movedMesh, spread, weld, weldOf } from '../../src/mesh/weld.ts';

/** Positions from few distinct numbers, so that many coincide. */
const positions = fc
  .array(fc.constantFrom(0, -0, 1, -1, 0.1, 1e300, 5e-324), { maxLength: 90 })
  .map((values) => Float64Array.from(values.slice(0, values.length - (values.length % 3))));

const keyOf = (x: Float64Array, p: number) => [x[3 * p], x[3 * p + 1], x[3 * p + 2]].map((v) => v + 0).join();

describe('weld', () => {
  it('joins what is equal, and nothing else, in order of first appearance', () => {
    fc.assert(
      fc.property(positions, (x) => {
        const count = x.length / 3;
        const joined = weld(x, new Uint32Array());
        const { vertexOfPosition } = joined;
        const welded = gather(x, joined);
        const keys = Array.from({ length: count }, (_, p) => keyOf(x, p));
        const distinct = [...new Set(keys)];
        expect(Array.from({ length: welded.length / 3 }, (_, v) => keyOf(welded, v))).toEqual(distinct);
        expect(Array.from(vertexOfPosition, (v) => distinct[v])).toEqual(keys);
      }),
      { seed: 7 },
    );
  });

  it('comes back through gather and spread, −0 as 0', () => {
    fc.assert(
      fc.property(positions, (x) => {
        const joined = weld(x, new Uint32Array());
        expect(spread(gather(x, joined), joined, x).map((v) => v + 0)).toEqual(x.map((v) => v + 0));
      }),
      { seed: 7 },
    );
  });

  it('renames triangles, leaves indices out of range alone, and does not touch its input', () => {
    const x = Float64Array.of(5, 5, 5, 0, 0, 0, 5, 5, 5);
    const triangles = Uint32Array.of(0, 1, 2, 2, 1, 99);
    expect(Array.from(weld(x, triangles).triangles)).toEqual([0, 1, 0, 0, 1, 99]);
    expect(Array.from(triangles)).toEqual([0, 1, 2, 2, 1, 99]);
  });

  it('keeps NaNs apart', () => {
    expect(weld(new Float64Array(6).fill(Number.NaN), new Uint32Array()).positionOfVertex).toHaveLength(2);
  });

  it('is carried on by what steps make of a mesh: what they bring together stays apart', () => {
    const mesh = {
      positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0),
      triangles: Uint32Array.of(0, 1, 2, 3, 2, 1),
    };
    const collapsed = movedMesh(mesh, new Float64Array(12));
    expect(Array.from(weldOf(collapsed).vertexOfPosition)).toEqual([0, 1, 2, 0]);
    expect(weldOf(collapsed)).toBe(weldOf(mesh));
    expect(weldOf(movedMesh(collapsed, mesh.positions))).toBe(weldOf(mesh));
  });
});
