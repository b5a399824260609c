import { expect, it } from 'vitest';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import { facesOfPatch } from '../../src/selection/face-sets.ts';
import { atOnce, selectableOf } from '../../src/selection/index.ts';
import { oppositeSide, outlookOf } from '../../src/selection/opposite-side.ts';
import { block, can } from '../fixtures/hard-edged.ts';
import { icosphere } from '../fixtures/meshes.ts';

const surfaceOf = (mesh: Pick<Mesh, 'positions' | 'triangles'>) => atOnce(selectableOf(mesh as Mesh));

/** The faces of the patch that looks a way. */
function sideOf(mesh: Pick<Mesh, 'positions' | 'triangles'>, way: readonly number[]) {
  const surface = surfaceOf(mesh);
  const faces = Array.from({ length: surface.topology.triangles.length / 3 }, (_, face) => face);
  const face = faces.find((one) => {
    const look = outlookOf(surface, Uint32Array.of(one));
    return look.every((value, k) => Math.abs(value - way[k]!) < 1e-6);
  })!;
  return { surface, faces: facesOfPatch(surface, face) };
}

it('of a block is the one across, whole, whichever is pulled', () => {
  const mesh = block(4);
  for (const [axis, sign] of [0, 1, 2].flatMap((axis) => [1, -1].map((sign) => [axis, sign] as const))) {
    const way = [0, 1, 2].map((k) => (k === axis ? sign : 0));
    const { surface, faces } = sideOf(mesh, way);
    const across = oppositeSide(surface, faces)!;
    expect(across).toHaveLength(25);
    const heights = [...across].map((vertex) => surface.places[3 * vertex + axis]! * sign);
    const lowest = surface.places.reduce(
      (low, x, k) => (k % 3 === axis ? Math.min(low, x * sign) : low),
      Infinity,
    );
    for (const height of heights) expect(height).toBeCloseTo(lowest, 9);
  }
});

it('of a cylinder’s lid is the other lid; its mantle looks nowhere, and neither does a ball', () => {
  const mesh = can(48, 12);
  const surface = surfaceOf(mesh);
  const looks = Array.from({ length: surface.patches.count }, (_, patch) => {
    const face = surface.patches.of.indexOf(patch);
    return { face, look: outlookOf(surface, facesOfPatch(surface, face)) };
  });
  const lids = looks.filter(({ look }) => look.some((value) => value !== 0));
  expect([looks.length, lids.length]).toEqual([3, 2]);
  const across = oppositeSide(surface, facesOfPatch(surface, lids[0]!.face))!;
  const wanted = facesOfPatch(surface, lids[1]!.face);
  const corners = new Set(
    [...wanted].flatMap((face) => [...surface.topology.triangles.slice(3 * face, 3 * face + 3)]),
  );
  expect(new Set(across)).toEqual(corners);
  const mantle = looks.find(({ look }) => look.every((value) => value === 0))!;
  expect(oppositeSide(surface, facesOfPatch(surface, mantle.face))).toBeNull();
  const ball = surfaceOf(icosphere(2));
  expect(oppositeSide(ball, facesOfPatch(ball, 0))).toBeNull();
  expect(weldOf(mesh as Mesh).positionOfVertex.length).toBe(surface.topology.vertices);
});
