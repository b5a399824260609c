import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { doubledAreaVector, row, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { verticesOfFaces } from '../../src/selection/face-sets.ts';
import { flatSideOf } from '../../src/selection/flat-sides.ts';
import {
  atOnce,
  candidateAt,
  oppositeSide,
  type SelectableMesh,
  selectableOf,
} from '../../src/selection/index.ts';
import { can } from '../fixtures/hard-edged.ts';
import { icosphere, type TestMesh } from '../fixtures/meshes.ts';
import { asDrawn, caseOf, meshed } from '../shapes/cases.ts';

const surfaceOf = (mesh: Pick<Mesh, 'positions' | 'triangles'>) => atOnce(selectableOf(mesh as Mesh));
const facesOf = ({ topology }: SelectableMesh) =>
  Array.from({ length: topology.triangles.length / 3 }, (_, face) => face);

/** A face that looks a way. */
function faceTowards(surface: SelectableMesh, way: Vec3): number {
  return facesOf(surface).find((face) => {
    const at = (corner: number) => row(surface.places, surface.topology.triangles[3 * face + corner]!);
    const look = unit(doubledAreaVector(at(0), at(1), at(2)));
    return look.every((value, k) => Math.abs(value - way[k]!) < 1e-6);
  })!;
}

/** The value that all of some vertices have along an axis. */
function heightOf({ places }: SelectableMesh, vertices: Uint32Array, axis: number): number {
  const heights = [...vertices].map((v) => places[3 * v + axis]!);
  expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(1e-9);
  return heights[0]!;
}

const roundedBoxes: [string, TestMesh][] = [
  ['of even faces', meshed(caseOf('rounded box'), 1.5)],
  ['of slivers', asDrawn(caseOf('rounded box'))],
];

describe.each(roundedBoxes)('a box with rounded edges, %s', (_, mesh) => {
  const surface = surfaceOf(mesh);

  it('has six flat sides in its one smooth patch, each in a plane of the box', () => {
    expect(surface.patches.count).toBe(1);
    for (const axis of [0, 1, 2])
      for (const sign of [1, -1]) {
        const way = [0, 1, 2].map((k) => (k === axis ? sign : 0)) as unknown as Vec3;
        const side = flatSideOf(surface, faceTowards(surface, way))!;
        const outermost =
          sign * Math.max(...mesh.positions.filter((_, i) => i % 3 === axis).map((x) => sign * x));
        expect(heightOf(surface, verticesOfFaces(surface, side), axis)).toBeCloseTo(outermost, 9);
      }
    const sides = new Set(facesOf(surface).flatMap((face) => flatSideOf(surface, face)?.[0] ?? []));
    expect(sides.size).toBe(6);
  });

  it('is taken by the side that is pointed at, and held by the one across', () => {
    const face = faceTowards(surface, [1, 0, 0]);
    const aim = { face, weights: [1 / 3, 1 / 3, 1 / 3], pointer: [0, 0], reach: 1e-6 } as const;
    const project = (v: number) => [surface.places[3 * v + 1]!, surface.places[3 * v + 2]!] as const;
    const { kind, vertices, sentence } = candidateAt(
      surface,
      { ...aim, project },
      { flatSide: true, spot: 0.1 },
    );
    expect([kind, sentence]).toEqual(['patch', `a flat side of ${vertices.length} vertices`]);
    const across = oppositeSide(surface, flatSideOf(surface, face)!)!;
    expect(heightOf(surface, across, 0)).toBeCloseTo(-heightOf(surface, vertices, 0), 9);
  });
});

it('nothing of a ball, a cylinder or its lids is one: a lid is a patch by itself', () => {
  for (const mesh of [icosphere(3), can(24, 6), can(8, 2), asDrawn(caseOf('rod of 12 sides'))]) {
    const surface = surfaceOf(mesh);
    expect(facesOf(surface).filter((face) => flatSideOf(surface, face))).toEqual([]);
  }
});
