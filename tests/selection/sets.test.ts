import { describe, expect, test } from 'vitest';
import {
  aloneIn,
  atOnce,
  boxRegion,
  combined,
  everything,
  grown,
  inverted,
  mirrored,
  mirrorMap,
  nothing,
  piecesOf,
  type ScreenPoint,
  type Selection,
  selectableOf,
  selectedVertices,
  shrunk,
  verticesInside,
} from '../../src/selection/index.ts';
import { block } from '../fixtures/hard-edged.ts';
import { bunny, type TestMesh, together } from '../fixtures/meshes.ts';
import { openCylinder, plate } from '../fixtures/shapes.ts';

const selected = (count: number, ...vertices: number[]) => combined(nothing(count), vertices, 'replace');
const list = (selection: Selection) => {
  const vertices = [...selectedVertices(selection)];
  expect(selection.count).toBe(vertices.length);
  return vertices;
};

describe('sets', () => {
  test('replace, add and remove', () => {
    const first = selected(9, 2, 4, 4, 8);
    expect(list(first)).toEqual([2, 4, 8]);
    expect(list(combined(first, [1, 4], 'add'))).toEqual([1, 2, 4, 8]);
    expect(list(combined(first, [1, 4], 'remove'))).toEqual([2, 8]);
    expect(list(combined(first, [1, 4], 'replace'))).toEqual([1, 4]);
    expect(list(first)).toEqual([2, 4, 8]);
    expect(list(inverted(first))).toEqual([0, 1, 3, 5, 6, 7]);
    expect(list(inverted(everything(4)))).toEqual([]);
  });

  test('grow by neighbours, shrink by those at the rim', () => {
    const { topology } = atOnce(selectableOf(plate(7)));
    const middle = selected(49, 24);
    expect(list(grown(middle, topology))).toEqual([16, 17, 23, 24, 25, 31, 32]);
    expect(list(shrunk(grown(middle, topology), topology))).toEqual([24]);
    expect(list(shrunk(middle, topology))).toEqual([]);
    expect(shrunk(everything(49), topology).count).toBe(49);
  });

  test('fall into pieces that touch', () => {
    const { topology } = atOnce(selectableOf(plate(7)));
    expect(piecesOf(selected(49, 0, 1, 8, 48, 40, 24), topology).map((piece) => piece.length)).toEqual([
      3, 1, 2,
    ]);
  });
});

describe('areas of the screen', () => {
  const places = Float64Array.from({ length: 2 * 100 }, (_, i) =>
    i % 2 === 0 ? (i / 2) % 10 : Math.floor(i / 20),
  );

  test('a box takes what is in it, drawn from whichever corner', () => {
    const inside = [22, 23, 32, 33];
    expect([...verticesInside(boxRegion([1.5, 1.5], [3.5, 3.5]), places)]).toEqual(inside);
    expect([...verticesInside(boxRegion([3.5, 1.5], [1.5, 3.5]), places)]).toEqual(inside);
    expect([...verticesInside(boxRegion([3.5, 3.5], [1.5, 1.5]), places, (v) => v !== 23)]).toEqual([
      22, 32, 33,
    ]);
  });

  test('a lasso takes what it goes around, as a test of every vertex against every line would', () => {
    const outline = Array.from({ length: 60 }, (_, i): ScreenPoint => {
      const radius = 2 + 1.9 * Math.sin((6 * Math.PI * i) / 60 + 0.1);
      return [
        4.6 + radius * Math.cos((2 * Math.PI * i) / 60),
        4.4 + radius * Math.sin((2 * Math.PI * i) / 60),
      ];
    });
    // The angle that the outline turns about a place is 0 outside.
    const turn = (x: number, y: number) =>
      outline.reduce((sum, [ax, ay], i) => {
        const [bx, by] = outline[(i + 1) % outline.length]!;
        const [ux, uy, vx, vy] = [ax - x, ay - y, bx - x, by - y];
        return sum + Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy);
      }, 0);
    const expected = Array.from({ length: 100 }, (_, v) => v).filter(
      (v) => Math.abs(turn(places[2 * v]!, places[2 * v + 1]!)) > 1,
    );
    expect(expected.length).toBeGreaterThan(8);
    expect([...verticesInside({ outline }, places)]).toEqual(expected);
  });

  test('what a lasso goes around twice is inside, what is not on the screen never', () => {
    const ring: ScreenPoint[] = [[1.5, 1.5], [3.5, 1.5], [3.5, 3.5], [1.5, 3.5]]; // biome-ignore format: a square
    expect([...verticesInside({ outline: [...ring, ...ring] }, places)]).toEqual([22, 23, 32, 33]);
    expect([
      ...verticesInside(
        { outline: ring },
        places.map((x) => (x === 2 ? Number.NaN : x)),
      ),
    ]).toEqual([33]);
    expect([...verticesInside({ outline: [] }, places)]).toEqual([]);
    expect([...verticesInside({ outline: [[1, 1]] }, places)]).toEqual([]);
  });
});

describe('the mirror', () => {
  const moved = ({ positions, triangles }: TestMesh, by: number): TestMesh => ({
    positions: positions.map((x, i) => (i % 3 === 0 ? x + by : x)),
    triangles,
  });
  const places = (mesh: TestMesh) => atOnce(selectableOf(mesh)).places;

  test('lies in the middle of the box of a symmetric mesh, and pairs all of its vertices', () => {
    const x = places(moved(block(6), 0.7));
    const map = atOnce(mirrorMap(x, 0));
    expect([map.plane, map.alone]).toEqual([{ axis: 0, offset: 0.7 }, 0]);
    map.partner.forEach((w, v) => {
      expect(map.partner[w]).toBe(v);
      expect(x[3 * v]! + x[3 * w]!).toBeCloseTo(1.4, 12);
      expect([...x.subarray(3 * v + 1, 3 * v + 3)]).toEqual([...x.subarray(3 * w + 1, 3 * w + 3)]);
    });
  });

  test('lies in the origin where the mesh is symmetric about that, though it holds something on one side', () => {
    const body = { mesh: block(6), offset: [0, 0, 0] as const };
    const map = atOnce(mirrorMap(places(together(body, { mesh: openCylinder(8, 2), offset: [4, 0, 0] })), 0));
    expect([map.plane, map.alone]).toEqual([{ axis: 0, offset: 0 }, 16]);
    const all = everything(map.partner.length);
    expect(aloneIn(all, map)).toBe(16);
    expect(mirrored(all, map).count).toBe(all.count - 16);
  });

  test('finds partners that are symmetric by eye alone', () => {
    const mesh = block(6);
    const rough = {
      ...mesh,
      positions: mesh.positions.map((x, i) => x + 1e-3 * Math.sin(12.9 * Math.round(40 * x) + (i % 3))),
    };
    expect(atOnce(mirrorMap(places(rough), 1)).alone).toBe(0);
  });

  test('says of a mesh that is not symmetric how many have no partner', () => {
    const { partner, alone } = atOnce(mirrorMap(places(bunny()), 0));
    expect(alone).toBeGreaterThan(0.5 * partner.length);
  });

  test('puts a selection on the other side', () => {
    const x = places(block(4));
    const right = selected(x.length / 3, ...[...Array(x.length / 3).keys()].filter((v) => x[3 * v]! > 0.6));
    const left = mirrored(right, atOnce(mirrorMap(x, 0)));
    expect(left.count).toBe(right.count);
    expect(list(left).every((v) => x[3 * v]! < -0.6)).toBe(true);
  });
});
