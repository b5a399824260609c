import { describe, expect, test } from 'vitest';
import {
  atOnce,
  combined,
  drawnOf,
  everything,
  nothing,
  type ScreenShape,
  selectableOf,
  Visibility,
} from '../../src/selection/index.ts';
import { block } from '../fixtures/hard-edged.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';
import { plate } from '../fixtures/shapes.ts';

const size = 400;

/** A camera on the z axis, 8 units away, that sees 4 units across a canvas of 400 pixels at the origin. */
function seen(mesh: TestMesh, facing: 'out' | 'in' | 'neither') {
  const { topology, places } = atOnce(selectableOf(mesh));
  const focal = 8 * 100;
  const screen: ScreenShape = {
    places: new Float32Array(2 * topology.vertices),
    depths: new Float32Array(topology.vertices),
    ...{ focal, width: size, height: size },
  };
  for (let v = 0; v < topology.vertices; v++) {
    const depth = 8 - places[3 * v + 2]!;
    screen.depths[v] = depth;
    screen.places[2 * v] = size / 2 + (focal * places[3 * v]!) / depth;
    screen.places[2 * v + 1] = size / 2 - (focal * places[3 * v + 1]!) / depth;
  }
  const visibility = atOnce(Visibility.of(topology, screen, facing));
  return { places, sees: (v: number) => visibility.sees(v), count: topology.vertices };
}

describe('what is seen', () => {
  test.each([
    ['coarse', 2],
    ['fine', 6],
  ] as const)('of a %s ball is its near side, out to the horizon', (_, levels) => {
    const { places, sees, count } = seen(icosphere(levels), 'out');
    for (let v = 0; v < count; v++) {
      // The horizon of a ball of radius 1 from 8 away is at z = 1/8; faces make it a little uncertain.
      const above = places[3 * v + 2]! - 1 / 8;
      if (Math.abs(above) > (levels === 2 ? 0.35 : 0.12)) expect([v, sees(v)]).toEqual([v, above > 0]);
    }
  });

  test('of a block are the corners that look here, its silhouette with them', () => {
    const { places, sees, count } = seen(block(8), 'out');
    for (let v = 0; v < count; v++) expect([v, sees(v)]).toEqual([v, places[3 * v + 2] === 1]);
  });

  test('is not what lies behind another sheet, though it looks here', () => {
    const sheets = [0, -0.5].map((z) => ({ mesh: plate(21), offset: [-0.5, -0.5, z] as const }));
    const { places, sees, count } = seen(together(...sheets), 'neither');
    const near = Array.from({ length: count }, (_, v) => v).filter(
      (v) => Math.abs(places[3 * v]!) < 0.4 && Math.abs(places[3 * v + 1]!) < 0.4,
    );
    expect(near.length).toBeGreaterThan(300);
    for (const v of near) expect(sees(v)).toBe(places[3 * v + 2] === 0);
  });

  test('is the near side of a thin plate alone, turned outside out or in', () => {
    const thin = block(12);
    const flat = { ...thin, positions: thin.positions.map((x, i) => (i % 3 === 2 ? x * 0.01 : x)) };
    const turned = {
      ...flat,
      triangles: flat.triangles.map((_, c) => flat.triangles[3 * Math.floor(c / 3) + 2 - (c % 3)]!),
    };
    for (const [mesh, facing] of [
      [flat, 'out'],
      [turned, 'in'],
    ] as const) {
      // biome-ignore format: pairs
      const { places, sees, count } = seen(mesh, facing);
      const inside = Array.from({ length: count }, (_, v) => v).filter(
        (v) => Math.max(Math.abs(places[3 * v]!), Math.abs(places[3 * v + 1]!)) < 0.9,
      );
      expect(inside.length).toBeGreaterThan(200);
      for (const v of inside) expect(sees(v)).toBe(places[3 * v + 2]! > 0);
    }
  });

  test('is nothing beside the canvas', () => {
    const { sees } = seen(together({ mesh: plate(3), offset: [9, 0, 0] }), 'neither');
    expect(sees(0)).toBe(false);
  });
});

describe('a selection is shown', () => {
  const { topology } = atOnce(selectableOf(plate(7)));

  test('by its whole faces, and by dots and lines where it has none', () => {
    const drawn = drawnOf(combined(nothing(49), [0, 1, 8, 24, 40, 41, 7], 'replace'), topology);
    expect(drawn.faces.length).toBe(2);
    expect([...drawn.vertices]).toEqual([24, 40, 41]);
    expect([...drawn.edges]).toEqual([40, 41]);
  });

  test('all of it by faces alone', () => {
    const { faces, edges, vertices } = drawnOf(everything(49), topology);
    expect([faces.length, edges.length, vertices.length]).toEqual([72, 0, 0]);
  });
});
