import { type Mesh as Drawable, Group, type Material } from 'three';
import { expect, it } from 'vitest';
import type { PointsLayer } from '../../src/viewer/layers/layer.ts';
import { Layers } from '../../src/viewer/layers/layers.ts';
import { Surface } from '../../src/viewer/surface.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';

const points = (): PointsLayer => ({
  kind: 'points',
  positions: Uint32Array.of(0, 1),
  color: '#f00',
  size: 5,
  depth: 'in-front',
});

/** Layers over a tetrahedron, on a viewer that draws when it is told to. */
function stand() {
  const overlay = new Group();
  const viewer = {
    canvas: { clientWidth: 300, clientHeight: 200 },
    drawings: 0,
    space: { surface: new Surface(tetrahedron()), overlay },
    onShape: () => () => undefined,
    invalidate: () => undefined,
  };
  const layers = new Layers(viewer as unknown as Viewer);
  const freed: Material[] = [];
  /** Sets the layer of the one name there is. @returns its material; null where there is none */
  const set = (layer: PointsLayer | null): Material | null => {
    layers.set('dots', layer);
    const drawn = overlay.children[0]?.children[0] as Drawable | undefined;
    const material = (drawn?.material ?? null) as Material | null;
    material?.addEventListener('dispose', () => freed.push(material));
    return material;
  };
  return { viewer, overlay, layers, freed, set };
}

it('frees a layer only after a picture with the one in its place, which takes over its linked program', () => {
  const { viewer, overlay, freed, set } = stand();
  const first = set(points());
  viewer.drawings++;
  const second = set(points());
  expect(overlay.children).toHaveLength(1);
  expect(freed).toEqual([]);
  // Never drawn, so it has no program.
  const third = set(points());
  expect(freed).toEqual([second]);
  viewer.drawings++;
  set(null);
  expect(overlay.children).toHaveLength(0);
  expect(freed).toEqual([second, first]);
  viewer.drawings++;
  set(points());
  expect(freed).toEqual([second, first, third]);
});

it('frees everything when another mesh takes all of it away', () => {
  const { viewer, overlay, layers, freed, set } = stand();
  const first = set(points());
  viewer.drawings++;
  const second = set(points());
  viewer.drawings++;
  layers.clear();
  expect(freed).toEqual([first, second]);
  expect(overlay.children).toHaveLength(0);
});
