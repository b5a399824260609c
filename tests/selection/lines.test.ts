import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { type Aim, atOnce, lineAt, type SelectableMesh, selectableOf } from '../../src/selection/index.ts';
import { inARow } from '../../src/selection/lines.ts';
import { block, can } from '../fixtures/hard-edged.ts';

const surfaceOf = (mesh: Pick<Mesh, 'positions' | 'triangles'>) => atOnce(selectableOf(mesh as Mesh));

/** A pointer on the edge between two places, seen along no axis, 100 pixels a unit. */
function aimAt(surface: SelectableMesh, a: readonly number[], b: readonly number[]): Aim {
  const { topology, places } = surface;
  const vertexAt = (place: readonly number[]) => {
    for (let v = 0; v < topology.vertices; v++)
      if (place.every((x, k) => Math.abs(places[3 * v + k]! - x) < 1e-9)) return v;
    throw new Error(`Nothing is at ${place}.`);
  };
  const ends = [vertexAt(a), vertexAt(b)];
  const faces = topology.triangles.length / 3;
  for (let face = 0; face < faces; face++) {
    const corners = [...topology.triangles.subarray(3 * face, 3 * face + 3)];
    if (!ends.every((end) => corners.includes(end))) continue;
    const project = (v: number) => {
      const [x, y, z] = [0, 1, 2].map((k) => 100 * places[3 * v + k]!) as [number, number, number];
      return [x + 0.31 * z, 0.17 * z - y] as const;
    };
    const [p, q] = ends.map(project) as [readonly [number, number], readonly [number, number]];
    const pointer = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2] as const;
    return { face, weights: [1 / 3, 1 / 3, 1 / 3], pointer, project, reach: 5 };
  }
  throw new Error('No face has both.');
}

const placesOf = ({ places }: SelectableMesh, vertices: readonly number[]) =>
  vertices.map((v) => [...places.subarray(3 * v, 3 * v + 3)]);

describe('a line that is meant', () => {
  it('is the whole sharp edge from corner to corner, its vertices in a row', () => {
    const surface = surfaceOf(block(4));
    const aim = aimAt(surface, [-0.5, 1, 1], [0, 1, 1]);
    for (const purpose of ['crease', 'smooth', 'straight'] as const) {
      const line = lineAt(surface, aim, purpose)!;
      expect(line.edges).toHaveLength(4);
      const xs = placesOf(surface, line.vertices).map(([x, y, z]) => {
        expect([y, z]).toEqual([1, 1]);
        return x!;
      });
      expect(xs[0]! < xs[1]! ? xs : xs.toReversed()).toEqual([-1, -0.5, 0, 0.5, 1]);
    }
  });

  it('goes straight on across a flat side, to its rim and no further', () => {
    const surface = surfaceOf(block(4));
    const aim = aimAt(surface, [-0.5, 0, 1], [0, 0, 1]);
    const line = lineAt(surface, aim, 'straight')!;
    const places = placesOf(surface, line.vertices);
    expect(places.map(([x]) => x).toSorted((a, b) => a! - b!)).toEqual([-1, -0.5, 0, 0.5, 1]);
    expect(places.every(([, y, z]) => y === 0 && z === 1)).toBe(true);
    expect(lineAt(surface, aim, 'crease')!.edges).toHaveLength(4);
    // What is smooth already cannot be made so.
    expect(lineAt(surface, aim, 'smooth')).toBeNull();
  });

  it('goes all around a rim and comes back to its first vertex; a straight one ends where the rim turns', () => {
    const columns = 24;
    const surface = surfaceOf(can(columns, 5));
    const angle = (k: number) => (2 * Math.PI * k) / columns;
    const at = (k: number) => [Math.cos(angle(k)), Math.sin(angle(k)), 1];
    const aim = aimAt(surface, at(3), at(4));
    const rim = lineAt(surface, aim, 'crease')!;
    expect(rim.edges).toHaveLength(columns);
    expect(rim.vertices).toHaveLength(columns + 1);
    expect(rim.vertices[0]).toBe(rim.vertices.at(-1));
    // Each turn is 15°.
    expect(lineAt(surface, aim, 'straight')!.edges).toHaveLength(1);
  });

  it('follows a bend of the surface that is too gentle to be sharp, and leaves it for none', () => {
    const columns = 16;
    const surface = surfaceOf(can(columns, 6));
    const angle = (2 * Math.PI * 3) / columns;
    // A line along the mantle, where it bends by 22.5°.
    const at = (z: number) => [Math.cos(angle), Math.sin(angle), z];
    const zs = [...new Set(Array.from(surface.places.filter((_, k) => k % 3 === 2)))].sort((a, b) => a - b);
    const aim = { ...aimAt(surface, at(zs[2]!), at(zs[3]!)), reach: 0 };
    const line = lineAt(surface, aim, 'crease')!;
    expect(line.edges).toHaveLength(zs.length - 1);
    for (const [x, y] of placesOf(surface, line.vertices)) {
      expect(x).toBeCloseTo(Math.cos(angle), 9);
      expect(y).toBeCloseTo(Math.sin(angle), 9);
    }
  });
});

it('edges in any order are put in a row', () => {
  const { topology } = surfaceOf(block(2));
  const edges = Array.from({ length: topology.ends.length / 2 }, (_, edge) => edge);
  const at = (v: number) =>
    edges.filter((edge) => topology.ends[2 * edge] === v || topology.ends[2 * edge + 1] === v);
  const [first, second] = at(0) as [number, number];
  const row = inARow(topology, Uint32Array.of(first, second));
  expect(row).toHaveLength(3);
  expect(row[1]).toBe(0);
});
