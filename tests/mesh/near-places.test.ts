import { describe, expect, it, test } from 'vitest';
import { movedMesh, spread, weld } from '../../src/mesh/weld.ts';
import { handles } from '../../src/methods/values/handles.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';

/** Numbers from −1 to 1 that look random and are always the same. */
function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
}

/** Every triangle with corners of its own, as in an STL file, each moved by up to `size`. */
function soup({ positions, triangles }: TestMesh, size: number): TestMesh {
  const next = noise(5);
  const corners = Float64Array.from(
    Array.from(triangles).flatMap((v) => Array.from(positions.subarray(3 * v, 3 * v + 3))),
    (x) => x + size * next(),
  );
  return { positions: corners, triangles: Uint32Array.from(triangles.keys()) };
}

/** The mesh cut open along the plane z = 0 (faces above have vertices of their own), its numbers rounded. */
function seam({ positions, triangles }: TestMesh, digits: number): TestMesh {
  const count = positions.length / 3;
  const isAbove = (c: number): boolean =>
    [0, 1, 2].reduce((sum, k) => sum + positions[3 * triangles[c - (c % 3) + k]! + 2]!, 0) > 0;
  const next = noise(3);
  const both = Float64Array.from([...positions, ...positions], (x) =>
    Number((x + 0.4 * 10 ** -digits * next()).toFixed(digits)),
  );
  return { positions: both, triangles: triangles.map((v, c) => (isAbove(c) ? v + count : v)) };
}

const used = (triangles: Uint32Array): number => new Set(triangles).size;

describe('places that differ by rounding', () => {
  test.each([1e-8, 1e-6, 1e-5])('a soup of triangles with noise of %f is one skin', (size) => {
    const ball = icosphere(3);
    const { positions, triangles } = soup(ball, size);
    const joined = weld(positions, triangles);
    expect(joined.positionOfVertex).toHaveLength(ball.positions.length / 3);
    expect(joined.near?.places).toBe(new Set(rows(positions)).size - ball.positions.length / 3);
    expect(isRenaming(joined.triangles, ball.triangles)).toBe(true);
  });

  test.each([4, 5, 6])('a seam that was written with %i digits is shut', (digits) => {
    const ball = icosphere(3);
    const { positions, triangles } = seam(ball, digits);
    expect(used(weld(positions, triangles).triangles)).toBe(used(ball.triangles));
  });

  it('is the same whatever the order of faces', () => {
    const { positions, triangles } = soup(icosphere(2), 1e-6);
    const forth = weld(positions, triangles);
    const back = weld(
      positions,
      triangles.map((_, c) => triangles[triangles.length - 1 - c]!),
    );
    expect(isRenaming(back.triangles.toReversed() as Uint32Array, forth.triangles)).toBe(true);
  });

  it('leaves a mesh without any as it was', () => {
    const ball = icosphere(3);
    const joined = weld(ball.positions, ball.triangles);
    expect(joined.near).toBeUndefined();
    expect(joined.triangles).toEqual(ball.triangles);
  });
});

describe('places that are really apart', () => {
  const ball = icosphere(3);
  const scaled = (mesh: TestMesh, by: number): TestMesh => ({
    ...mesh,
    positions: mesh.positions.map((x) => by * x),
  });
  const pair = (by: number): TestMesh =>
    together({ mesh: ball, offset: [0, 0, 0] }, { mesh: scaled(ball, by), offset: [0, 0, 0] });

  test.each([1 - 4e-3, 1 - 1e-4, 1 - 2e-5])('two skins, the inner %f times the outer', (by) => {
    const { positions, triangles } = pair(by);
    expect(weld(positions, triangles).near).toBeUndefined();
  });

  test('two open sheets, rims included', () => {
    const half = { ...ball, triangles: ball.triangles.filter((_, c) => c < ball.triangles.length / 2) };
    const { positions, triangles } = together(
      { mesh: half, offset: [0, 0, 0] },
      { mesh: half, offset: [0, 0, 8e-5] },
    );
    expect(weld(positions, triangles).near).toBeUndefined();
  });

  test('a part so fine that its edges are shorter than what is joined elsewhere', () => {
    const fine = soup(scaled(ball, 1e-4), 1e-9);
    const { positions, triangles } = together(
      { mesh: ball, offset: [0, 0, 0] },
      { mesh: fine, offset: [3, 0, 0] },
    );
    const joined = weld(positions, triangles);
    expect(joined.positionOfVertex).toHaveLength((2 * ball.positions.length) / 3);
    for (let c = 0; c < joined.triangles.length; c += 3)
      expect(new Set(joined.triangles.subarray(c, c + 3)).size).toBe(3);
  });

  test('a chain of places, each near the next: no edge collapses', () => {
    // 40 specks beside each other, each a triangle of its own.
    const specks = Array.from({ length: 40 }, (_, i) => [4e-5 * i, 0, 0, 4e-5 * i, 1, 0, 1, 4e-5 * i, 0]);
    const positions = Float64Array.from(specks.flat());
    const { triangles } = weld(
      positions,
      Uint32Array.from({ length: 120 }, (_, c) => c),
    );
    for (let c = 0; c < triangles.length; c += 3) expect(new Set(triangles.subarray(c, c + 3)).size).toBe(3);
    const first = new Map<number, number>();
    for (const [c, v] of triangles.entries()) {
      const twin = first.get(v) ?? c;
      first.set(v, twin);
      for (let axis = 0; axis < 3; axis++)
        expect(Math.abs(positions[3 * c + axis]! - positions[3 * twin + axis]!)).toBeLessThan(8e-5);
    }
  });

  test('a stray vertex or part a thousand diagonals away makes nothing nearer', () => {
    const speck: TestMesh = {
      positions: Float64Array.of(0, 0, 0, 1e-3, 0, 0, 0, 1e-3, 0),
      triangles: Uint32Array.of(0, 1, 2),
    };
    const skins = pair(1 - 4e-3);
    const { positions, triangles } = together(
      { mesh: skins, offset: [0, 0, 0] },
      { mesh: speck, offset: [3e4, 0, 0] },
    );
    const stray = Float64Array.of(...positions, 1e6, 0, 0, Number.NaN, 0, Number.POSITIVE_INFINITY);
    expect(weld(stray, triangles).near).toBeUndefined();
  });
});

describe('what is joined goes home', () => {
  const { positions, triangles } = soup(icosphere(2), 1e-6);
  const joined = weld(positions, triangles);

  it('to the bit where nothing moved', () => {
    const welded = gather(positions, joined.positionOfVertex);
    expect(spread(welded, joined, positions)).toEqual(positions);
  });

  it('with the distances that the file has', () => {
    const welded = gather(positions, joined.positionOfVertex).map((x) => 2 * x + 1);
    const moved = spread(welded, joined, positions);
    joined.vertexOfPosition.forEach((v, p) => {
      const first = joined.positionOfVertex[v]!;
      for (let axis = 0; axis < 3; axis++) {
        const was = positions[3 * p + axis]! - positions[3 * first + axis]!;
        expect(moved[3 * p + axis]! - moved[3 * first + axis]!).toBeCloseTo(was, 12);
      }
    });
  });

  it('held by any of its positions', () => {
    const [p, q] = twins(joined.vertexOfPosition);
    const at = (place: number) =>
      [...positions.subarray(3 * place, 3 * place + 3)] as [number, number, number];
    const descriptor = {
      name: 'handles',
      kind: 'handles',
      label: '',
      doc: '',
      invalidates: 'system',
    } as const;
    const held = (value: Parameters<typeof handles.encode>[1]) => handles.encode(descriptor, value, joined);
    const one = held({ vertices: [q], targets: [at(q)] });
    expect([...one.indices]).toEqual([joined.vertexOfPosition[p]]);
    at(p).forEach((x, axis) => {
      expect(one.numbers[axis]).toBeCloseTo(x, 14);
    });
    expect(held({ vertices: [p, q], targets: [at(p), at(q)] }).indices).toHaveLength(1);
    expect(
      held({
        vertices: [p, q],
        targets: [
          [1, 2, 3],
          [1, 2, 3],
        ],
      }).indices,
    ).toHaveLength(1);
    expect(() =>
      held({
        vertices: [p, q],
        targets: [
          [1, 2, 3],
          [1, 2, 3.001],
        ],
      }),
    ).toThrow(/same point/);
  });

  it('and stays joined through steps', () => {
    const mesh = { positions, triangles, weld: joined };
    expect(
      movedMesh(
        mesh,
        positions.map((x) => 3 * x),
      ).weld,
    ).toBe(joined);
    expect(joined.positionOfVertex).toHaveLength(162);
  });
});

function gather(positions: Float64Array, of: Uint32Array): Float64Array {
  return Float64Array.from(Array.from(of).flatMap((p) => Array.from(positions.subarray(3 * p, 3 * p + 3))));
}

function rows(positions: Float64Array): string[] {
  return Array.from({ length: positions.length / 3 }, (_, p) => positions.subarray(3 * p, 3 * p + 3).join());
}

/** Two positions of one vertex, the first of them its first. */
function twins(vertexOfPosition: Uint32Array): [number, number] {
  const first = vertexOfPosition.indexOf(3);
  return [first, vertexOfPosition.indexOf(3, first + 1)];
}

/** Whether two lists name the same things by other numbers. */
function isRenaming(a: Uint32Array, b: Uint32Array): boolean {
  const forth = new Map<number, number>();
  const back = new Map<number, number>();
  return (
    a.length === b.length &&
    a.every((v, i) => {
      const w = b[i]!;
      const isKnown = forth.has(v) || back.has(w);
      if (!isKnown) {
        forth.set(v, w);
        back.set(w, v);
      }
      return forth.get(v) === w && back.get(w) === v;
    })
  );
}
