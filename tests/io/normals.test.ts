import { describe, expect, it } from 'vitest';
import { newFaceNormals, newNormals } from '../../src/io/normals.ts';
import { none, triangleFaces } from '../../src/io/parsed-file.ts';
import { cubeNormals, cubePositions, cubeQuads } from '../fixtures/tiny-files.ts';

/** Two triangles that share the edge from (0,0,0) to (0,1,0): a roof, flat at first. */
const flat = Float64Array.of(0, 0, 0, 0, 1, 0, -1, 0, 0, 1, 0, 0);
const folded = Float64Array.of(0, 0, 1, 0, 1, 1, -1, 0, 0, 1, 0, 0);
const roof = triangleFaces(Uint32Array.of(0, 1, 2, 0, 3, 1));
const up = (n: number) => Float64Array.from({ length: 3 * n }, (_, i) => (i % 3 === 2 ? 1 : 0));
const rounded = (values: Float64Array) => Array.from(values, (value) => Math.round(value * 1e6) / 1e6 + 0);
const [s] = rounded(Float64Array.of(Math.SQRT1_2));

describe('newNormals', () => {
  it('lets a smooth edge stay smooth and gives each end its own side', () => {
    const normals = newNormals(roof, flat, folded, { values: up(4), ofCorner: roof.corners });
    expect(rounded(normals)).toEqual([0, 0, 1, 0, 0, 1, -s, 0, s, s, 0, s]);
  });

  it('keeps a hard edge hard: normals that differ do not share faces', () => {
    const values = Float64Array.of(-0.1, 0, 1, 0.1, 0, 1);
    const normals = newNormals(roof, flat, folded, { values, ofCorner: Uint32Array.of(0, 0, 0, 1, 1, 1) });
    expect(rounded(normals)).toEqual([-s, 0, s, s, 0, s]);
  });

  it('stays smooth across a texture seam that doubles positions and normals', () => {
    const split = triangleFaces(Uint32Array.of(0, 1, 2, 4, 3, 5));
    const seam = (x: Float64Array) => Float64Array.of(...x, ...x.subarray(0, 6));
    const normals = newNormals(split, seam(flat), seam(folded), { values: up(6), ofCorner: split.corners });
    expect(rounded(normals).slice(0, 6)).toEqual([0, 0, 1, 0, 0, 1]);
    expect(rounded(normals).slice(12)).toEqual([0, 0, 1, 0, 0, 1]);
  });

  it('weighs by area', () => {
    const wide = folded.slice();
    wide[9] = 3; // the right side is three times as wide, and as deep
    wide[11] = -2;
    const [x, y, z] = newNormals(roof, flat, wide, { values: up(4), ofCorner: roof.corners });
    expect([x, y, z]).toEqual([2, 0, 4].map((value) => expect.closeTo(value / Math.hypot(2, 4), 6)));
  });

  it('keeps the side of normals that point inward', () => {
    const values = up(4).map((value) => -value);
    const normals = newNormals(roof, flat, folded, { values, ofCorner: roof.corners });
    expect(rounded(normals).slice(0, 3)).toEqual([0, 0, -1]);
  });

  it('leaves what has not moved, has no area or is not used', () => {
    expect(newNormals(roof, flat, flat, { values: up(4), ofCorner: roof.corners }).every(Number.isNaN)).toBe(
      true,
    );
    const nowhere = new Float64Array(12);
    expect(
      newNormals(roof, flat, nowhere, { values: up(4), ofCorner: roof.corners }).every(Number.isNaN),
    ).toBe(true);
    const unused = new Uint32Array(6).fill(none);
    expect(newNormals(roof, flat, folded, { values: up(4), ofCorner: unused }).every(Number.isNaN)).toBe(
      true,
    );
    const half = flat.slice();
    half[11] = 1; // only the right triangle
    const normals = newNormals(roof, flat, half, { values: up(4), ofCorner: roof.corners });
    expect(Array.from(normals, Number.isNaN)).toEqual(
      [3, 3, 3].flatMap(() => [false, false, false]).toSpliced(6, 0, true, true, true),
    );
  });

  it('turns with the mesh: a rotated cube has rotated normals', () => {
    const faces = {
      start: Uint32Array.from({ length: 7 }, (_, f) => 4 * f),
      corners: Uint32Array.from(cubeQuads.flat()),
    };
    const turn = (x: readonly number[]) =>
      Float64Array.from(x, (_, i) => (i % 3 === 0 ? x[i + 1] : i % 3 === 1 ? -x[i - 1] : x[i]) + 0);
    const ofCorner = Uint32Array.from({ length: 24 }, (_, c) => c >> 2);
    const stored = { values: Float64Array.from(cubeNormals), ofCorner };
    const normals = newNormals(faces, Float64Array.from(cubePositions), turn(cubePositions), stored);
    expect(rounded(normals)).toEqual(Array.from(turn(cubeNormals)));
    expect(
      rounded(newFaceNormals(faces, Float64Array.from(cubePositions), turn(cubePositions), stored.values)),
    ).toEqual(rounded(normals));
  });
});
