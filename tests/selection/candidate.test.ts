import { describe, expect, test } from 'vitest';
import {
  type Aim,
  atOnce,
  type CandidateOptions,
  candidateAt,
  type SelectableMesh,
  selectableOf,
} from '../../src/selection/index.ts';
import { block, can } from '../fixtures/hard-edged.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';
import { patch, plate } from '../fixtures/shapes.ts';

/** Looks along −z at 100 pixels a unit, and points at a place of the surface that is seen there. */
function pointAt(surface: SelectableMesh, x: number, y: number, reach = 6): Aim {
  const { places, topology } = surface;
  const project = (v: number) => [100 * places[3 * v]!, 100 * places[3 * v + 1]!] as const;
  const pointer = [100 * x, 100 * y] as const;
  let best: { face: number; weights: [number, number, number]; z: number } | null = null;
  for (let face = 0; 3 * face < topology.triangles.length; face++) {
    const [a, b, c] = [0, 1, 2].map((k) => topology.triangles[3 * face + k]!) as [number, number, number];
    const [p, q, r] = [project(a), project(b), project(c)];
    const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if (!(area > 0)) continue;
    const u = ((q[0] - pointer[0]) * (r[1] - pointer[1]) - (q[1] - pointer[1]) * (r[0] - pointer[0])) / area;
    const v = ((r[0] - pointer[0]) * (p[1] - pointer[1]) - (r[1] - pointer[1]) * (p[0] - pointer[0])) / area;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const z = u * places[3 * a + 2]! + v * places[3 * b + 2]! + (1 - u - v) * places[3 * c + 2]!;
    if (!best || z > best.z) best = { face, weights: [u, v, 1 - u - v], z };
  }
  return { face: best!.face, weights: best!.weights, pointer, project, reach };
}

function clickOn(mesh: TestMesh, x: number, y: number, options: Partial<CandidateOptions> = {}) {
  const surface = atOnce(selectableOf(mesh));
  const candidate = candidateAt(surface, pointAt(surface, x, y), { spot: 0.3, ...options });
  const at = (v: number) => [...surface.places.subarray(3 * v, 3 * v + 3)];
  return { ...candidate, surface, at, places: [...candidate.vertices].map(at) };
}

describe('a click takes', () => {
  test('the side of a block, up to its edges', () => {
    const { kind, sentence, places, faces, edges } = clickOn(block(4), 0.1, 0.2);
    expect([kind, sentence]).toEqual(['patch', 'a smooth patch of 25 vertices']);
    expect(places.every(([, , z]) => z === 1)).toBe(true);
    expect([faces.length, edges.length]).toEqual([32, 2 * 16]);
  });

  test('the edge of a block from corner to corner, with the pointer near it', () => {
    const { kind, sentence, places, edges } = clickOn(block(4), 0.1, 0.96);
    expect([kind, sentence]).toEqual(['line', 'an edge, 5 vertices']);
    expect(places.every(([, y, z]) => y === 1 && z === 1)).toBe(true);
    expect(edges.length).toBe(8);
  });

  test('the rim of a can all around, and its lid', () => {
    const rim = clickOn(can(32, 4), 0, 0.98);
    expect([rim.kind, rim.sentence]).toEqual(['line', 'an edge all around, 32 vertices']);
    expect(rim.places.every(([, , z]) => z === 2)).toBe(true);
    const lid = clickOn(can(32, 4), 0.2, 0.3);
    expect([lid.kind, lid.vertices.length]).toEqual(['patch', 33]);
  });

  test('the rim of an opening as a whole, corners and all', () => {
    const { kind, sentence } = clickOn(plate(7), 0.5, 0.02);
    expect([kind, sentence]).toEqual(['rim', 'the rim of an opening, 24 vertices']);
  });

  test('the rim of one of two sheets that touch in a corner', () => {
    const sheets = [0, 1].map((offset) => ({ mesh: plate(4), offset: [offset, offset, 0] as const }));
    const { kind, places } = clickOn(together(...sheets), 0.5, 0.02);
    expect([kind, places.length]).toEqual(['rim', 12]);
    expect(places.every(([x, y]) => x! <= 1 && y! <= 1)).toBe(true);
  });

  test('the part where it is smooth and there are others', () => {
    const mesh = together(
      { mesh: icosphere(2), offset: [0, 0, 0] },
      { mesh: icosphere(1), offset: [3, 0, 0] },
    );
    expect(clickOn(mesh, 0.2, 0.1).sentence).toBe('a separate part, 162 vertices');
    expect(clickOn(mesh, 3, 0.1).vertices.length).toBe(42);
  });

  test('a round spot of a shape that has neither lines nor parts, and says what else there is', () => {
    const { kind, sentence, places, faces } = clickOn(icosphere(4), 0.2, 0.1);
    expect(kind).toBe('spot');
    expect(sentence).toMatch(/^a round spot of \d+ vertices, as there are no edges to go by; drag to brush$/);
    expect(places.length).toBeGreaterThan(20);
    expect(faces.length).toBeGreaterThan(20);
    expect(places.every(([x, y, z]) => Math.hypot(x! - 0.2, y! - 0.1, z! - Math.sqrt(0.95)) < 0.302)).toBe(
      true,
    );
  });

  test('no crumb of a rough surface, but what is around it', () => {
    // One face of a fine ball stands up like a scale.
    const ball = icosphere(4);
    const positions = ball.positions.slice();
    const top = positions.findIndex((z, i) => i % 3 === 2 && z > 0.97) - 2;
    for (let k = 0; k < 3; k++) positions[top + k]! *= 1.06;
    const [x, y] = [positions[top]! + 0.01, positions[top + 1]! + 0.01];
    expect(atOnce(selectableOf({ ...ball, positions })).features).toContain(1);
    expect(clickOn({ ...ball, positions }, x, y).kind).toBe('spot');
  });

  test('no smooth patch that has all but crumbs', () => {
    const ball = icosphere(4);
    const positions = ball.positions.slice();
    const bottom = ball.triangles.findIndex((v) => positions[3 * v + 2]! < -0.97);
    for (const v of ball.triangles.subarray(bottom - (bottom % 3), bottom - (bottom % 3) + 3))
      for (let k = 0; k < 3; k++) positions[3 * v + k]! *= 1.12;
    expect(atOnce(selectableOf({ ...ball, positions })).patches.count).toBeGreaterThan(1);
    expect(clickOn({ ...ball, positions }, 0.2, 0.1).kind).toBe('spot');
  });

  test('one vertex, or the whole part, where that is asked for', () => {
    const one = clickOn(block(4), 0.06, 0.45, { oneVertex: true });
    expect([one.sentence, one.places]).toEqual(['one vertex', [[0, 0.5, 1]]]);
    const part = clickOn(block(4), 0.1, 0.2, { wholePart: true });
    expect([part.kind, part.sentence]).toEqual(['part', 'the whole shape, 98 vertices']);
  });
});

test('a line goes straight on where others branch off', () => {
  // A sheet with a wall on its middle line, and another that meets it half-way.
  const across = patch({ columns: 7, rows: 3 }, (s, t) => [s, 0.5, t]);
  const half = patch({ columns: 4, rows: 3 }, (s, t) => [0.5, s / 2, t]);
  const sheets = [plate(7), across, half].map((mesh) => ({ mesh, offset: [0, 0, 0] as const }));
  const straight = clickOn(together(...sheets), 0.25, 0.52);
  expect(straight.places.map(([x]) => x!).toSorted()).toEqual([0, 1, 2, 3, 4, 5, 6].map((i) => i / 6));
  expect(straight.places.every(([, y, z]) => y === 0.5 && z === 0)).toBe(true);
  const branch = clickOn(together(...sheets), 0.52, 0.25);
  expect(branch.places.map(([, y]) => y!).toSorted()).toEqual([0, 1, 2, 3].map((i) => i / 6));
});

test('a patch that is pointed at again is not made again', () => {
  const surface = atOnce(selectableOf(block(4)));
  const first = candidateAt(surface, pointAt(surface, 0.1, 0.2), { spot: 0.1 });
  expect(candidateAt(surface, pointAt(surface, -0.3, -0.1), { spot: 0.1 })).toBe(first);
});
