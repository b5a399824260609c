import { Group, PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { Picking } from '../../src/viewer/picking/picking.ts';
import { SameThread } from '../../src/viewer/picking/tree-thread.ts';
import { Surface } from '../../src/viewer/surface.ts';
import type { ShapeChange, Viewer } from '../../src/viewer/viewer.ts';

/** A unit square at x = `at`, seen from the right, of two triangles. */
function square(at: number): Mesh {
  const positions = Float64Array.of(at, 0, 0, at, 1, 0, at, 1, 1, at, 0, 1);
  return { positions, triangles: Uint32Array.of(0, 1, 2, 0, 2, 3) };
}

/** What picking sees of a viewer: a camera on the x axis of the file, looking at the middle of what is drawn. */
function fakeViewer(mesh: Mesh) {
  const camera = new PerspectiveCamera(30, 1, 0.05, 60);
  camera.position.set(5, 0, 0);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const listeners = new Set<(change: ShapeChange) => void>();
  const overlay = new Group();
  let surface = new Surface(mesh);
  const fake = {
    canvas: { clientWidth: 200, clientHeight: 200 },
    get space() {
      return { camera, overlay, surface };
    },
    onShape(listener: (change: ShapeChange) => void) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
  const tell = (change: ShapeChange) => {
    for (const listener of listeners) listener(change);
  };
  return {
    viewer: fake as unknown as Viewer,
    show(other: Mesh) {
      surface = new Surface(other);
      tell('mesh');
    },
    move(positions: Float64Array) {
      surface.write(positions);
      tell('positions');
    },
  };
}

const middle = { x: 100, y: 100 };

describe('picking', () => {
  it('finds face, place, weights and normal under a pointer, in the file’s units', async () => {
    const { viewer } = fakeViewer(square(7));
    const picking = new Picking(viewer, () => new SameThread());
    expect(picking.pick(middle)).toBeNull();
    await picking.ready();
    const hit = picking.pick({ x: 100, y: 95 })!;
    expect(hit.point[0]).toBeCloseTo(7, 5);
    expect(hit.normal.map((value) => Math.round(1e9 * value) / 1e9)).toEqual([1, 0, 0]);
    const positions = square(7).positions;
    for (const axis of [0, 1, 2]) {
      const mixed = hit.corners.reduce(
        (sum, corner, k) => sum + hit.weights[k]! * positions[3 * corner + axis]!,
        0,
      );
      expect(mixed).toBeCloseTo(hit.point[axis]!, 5);
    }
    const place = picking.project(hit.point);
    expect([place.x, place.y]).toEqual([expect.closeTo(100, 3), expect.closeTo(95, 3)]);
    expect(picking.pick({ x: 2, y: 2 })).toBeNull();
  });

  it('follows a shape that moved and a mesh that took its place', async () => {
    const { viewer, move, show } = fakeViewer(square(0));
    const picking = new Picking(viewer, () => new SameThread());
    await picking.ready();
    move(square(3).positions);
    await picking.ready();
    expect(picking.pick(middle)!.point[0]).toBeCloseTo(3, 5);
    show(square(-2));
    expect(picking.pick(middle)).toBeNull();
    await picking.ready();
    expect(picking.pick(middle)!.point[0]).toBeCloseTo(-2, 5);
  });

  it('finds what is nearest, and a normal that looks at the one who looks', async () => {
    const near = square(1).positions;
    const far = square(0).positions;
    const mesh: Mesh = {
      positions: Float64Array.of(...far, ...near),
      triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6),
    };
    const picking = new Picking(fakeViewer(mesh).viewer, () => new SameThread());
    await picking.ready();
    expect(picking.pick(middle)!.point[0]).toBeCloseTo(1, 5);
    expect(picking.pick(middle)!.normal).toEqual([1, 0, 0]);
  });
});
