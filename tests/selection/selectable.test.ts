import { describe, expect, test } from 'vitest';
import { weldOf } from '../../src/mesh/weld.ts';
import {
  atOnce,
  discAround,
  inSlices,
  type SelectableOptions,
  selectableOf,
} from '../../src/selection/index.ts';
import { block, can } from '../fixtures/hard-edged.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';
import { family, openCylinder, plate, pretzel, torus } from '../fixtures/shapes.ts';

const surface = (mesh: TestMesh, options: SelectableOptions = {}) => atOnce(selectableOf(mesh, options));
const countOf = (features: Uint8Array, kind: number) => features.filter((one) => one === kind).length;

describe('feature edges', () => {
  test.each([
    ['a block', block(4), 12 * 4, 6],
    ['a can', can(24, 5), 2 * 24, 3],
    ['a can of twelve sides', can(12, 3), 2 * 12, 3],
    ['a ball', icosphere(2), 0, 1],
    ['a torus', torus(24, 12), 0, 1],
    ['a pretzel', pretzel(3), 0, 1],
  ] as const)('%s has its own, and the smooth patches between them', (_, mesh, edges, patches) => {
    const { features, patches: found, topology } = surface(mesh);
    expect(countOf(features, 1)).toBe(edges);
    expect(countOf(features, 2)).toBe(0);
    expect(found.count).toBe(patches);
    expect(found.members.toSorted()).toEqual(
      Uint32Array.from({ length: topology.triangles.length / 3 }, (_, f) => f),
    );
  });

  test('borders are features, whatever the angle', () => {
    const { features, patches } = surface(openCylinder(20, 4), { angle: 180 });
    expect([countOf(features, 1), countOf(features, 2), patches.count]).toEqual([0, 40, 1]);
  });

  test('the angle decides: sides of an octagonal can bend by 45°', () => {
    expect(surface(can(8, 2), { angle: 44 }).patches.count).toBe(10);
    expect(surface(can(8, 2), { angle: 46 }).patches.count).toBe(3);
  });

  test('they are those of the shape that is shown', () => {
    const mesh = block(3);
    const round = mesh.positions.map((x, i) => {
      const at = 3 * Math.floor(i / 3);
      return x / Math.hypot(...mesh.positions.subarray(at, at + 3));
    });
    expect(surface(mesh, { positions: round }).patches.count).toBe(1);
    expect(surface(mesh).patches.count).toBe(6);
  });

  test('a sliver neither joins two sides of an edge nor is cut out of one', () => {
    // A square of two triangles, a wall along y = 0, and between them a face without area.
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0.5, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1);
    const triangles = Uint32Array.of(0, 1, 4, 0, 4, 3, 0, 2, 1, 0, 5, 2, 5, 6, 2, 6, 1, 2);
    const { patches } = surface({ positions, triangles });
    expect(patches.count).toBe(2);
    expect(patches.of[2]).toBe(patches.of[0]);
    expect(patches.of[3]).not.toBe(patches.of[0]);
  });

  test('where three sheets meet is an edge', () => {
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1);
    const { features, patches } = surface({
      positions,
      triangles: Uint32Array.of(0, 1, 2, 1, 0, 3, 0, 1, 4),
    });
    expect([countOf(features, 1), patches.count]).toEqual([1, 3]);
  });
});

describe('parts', () => {
  test('are connected by vertices, and all vertices are in one', () => {
    const { parts, facesOfParts } = surface(family());
    expect(parts.count).toBe(3);
    expect(facesOfParts.count).toBe(3);
    expect(parts.members.length).toBe(surface(family()).topology.vertices);
  });

  test('seams do not cut them', () => {
    expect(surface(block(2)).parts.count).toBe(1);
    expect(
      surface(together({ mesh: block(2), offset: [0, 0, 0] }, { mesh: block(2), offset: [2, 0, 0] })).parts
        .count,
    ).toBe(1);
  });
});

test('a disc stays on its side of a slit that the ball reaches over', () => {
  const mesh = together({ mesh: plate(21), offset: [0, 0, 0] }, { mesh: plate(21), offset: [0, 0, 0.01] });
  const sheet = surface(mesh);
  const disc = discAround(sheet, { face: 400, weights: [1, 0, 0] }, 0.2);
  expect(disc.length).toBeGreaterThan(25);
  expect(new Set([...disc].map((v) => sheet.parts.of[v])).size).toBe(1);
  const centre = sheet.places.subarray(
    3 * sheet.topology.triangles[1200]!,
    3 * sheet.topology.triangles[1200]! + 3,
  );
  for (const v of disc)
    expect(Math.hypot(...[0, 1, 2].map((k) => sheet.places[3 * v + k]! - centre[k]!))).toBeLessThanOrEqual(
      0.2,
    );
});

describe('work in slices', () => {
  test('leads where it leads at once, and lets others have their turn between pieces', async () => {
    const mesh = torus(120, 60);
    weldOf(mesh);
    let pauses = 0;
    const sliced = await inSlices(selectableOf({ ...mesh }), {
      budget: 0,
      pause: async () => {
        pauses++;
      },
    });
    expect(pauses).toBeGreaterThan(8);
    const whole = surface(mesh);
    expect(sliced.features).toEqual(whole.features);
    expect(sliced.patches).toEqual(whole.patches);
    expect(sliced.topology).toEqual(whole.topology);
  });

  test('ends at its next pause when nobody waits for it any more', async () => {
    const stop = new AbortController();
    const pause = async () => stop.abort(new Error('enough'));
    await expect(
      inSlices(selectableOf(torus(40, 20)), { budget: 0, pause, signal: stop.signal }),
    ).rejects.toThrow('enough');
  });
});
