import { ConeGeometry, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from 'three';
import { row } from '../../mesh/vectors.ts';
import type { Surface } from '../surface.ts';
import type { ArrowsLayer, DrawnLayer } from './layer.ts';
import { drawLines, toView } from './lines.ts';

const up = new Vector3(0, 1, 0);
/** Length of a head, in view units. */
const head = 0.05;

/** Arrows; those that would be shorter than half their head are left out. */
export function drawArrows(layer: ArrowsLayer, surface: Surface): DrawnLayer {
  const { color, depth, width } = layer;
  const from = toView(layer.from, surface);
  const to = toView(layer.to, surface);
  const ways = Array.from({ length: from.length / 3 }, (_, k) => ({
    k,
    start: new Vector3(...row(from, k)),
    end: new Vector3(...row(to, k)),
  })).filter(({ start, end }) => start.distanceTo(end) > head / 2);
  const places = ways.flatMap(({ k }) => [...row(layer.from, k), ...row(layer.to, k)]);
  const shafts = drawLines({ kind: 'lines', places, width, color, depth }, surface);
  const geometry = new ConeGeometry(head * 0.36, head, 12).translate(0, -head / 2, 0);
  const material = new MeshBasicMaterial({ color, toneMapped: false, depthTest: depth === 'hidden-behind' });
  material.transparent = true;
  const heads = new InstancedMesh(geometry, material, ways.length);
  heads.frustumCulled = false;
  heads.renderOrder = 2;
  ways.forEach(({ start, end }, k) => {
    const turn = new Quaternion().setFromUnitVectors(up, end.clone().sub(start).normalize());
    heads.setMatrixAt(k, new Matrix4().compose(end, turn, new Vector3(1, 1, 1)));
  });
  const object = new Group().add(shafts.object, heads);
  return {
    object,
    resize: (w, h) => shafts.resize?.(w, h),
    dispose() {
      shafts.dispose();
      heads.dispose();
      geometry.dispose();
      material.dispose();
    },
  };
}
