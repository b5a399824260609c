import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Quaternion,
  Vector3,
} from 'three';
import type { Surface } from '../surface.ts';
import type { DrawnLayer, FacesLayer, SheetLayer } from './layer.ts';
import { toView } from './lines.ts';
import { letGo, passesOf } from './passes.ts';

/** Some of the surface's triangles, tinted, over its own buffer of positions. */
export function drawFaces(layer: FacesLayer, surface: Surface): DrawnLayer {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', surface.geometry.getAttribute('position'));
  geometry.setIndex(new BufferAttribute(layer.corners, 1));
  return tinted(layer, geometry);
}

/** A square around a place. */
export function drawSheet(layer: SheetLayer, surface: Surface): DrawnLayer {
  const side = 2 * layer.reach * surface.frame.scale;
  const drawn = tinted(layer, new PlaneGeometry(side, side));
  drawn.object.position.fromArray(toView(layer.center, surface));
  drawn.object.quaternion.copy(
    new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...layer.normal).normalize()),
  );
  return drawn;
}

function tinted({ color, opacity, depth }: FacesLayer | SheetLayer, geometry: BufferGeometry): DrawnLayer {
  const object = new Group();
  const materials = passesOf(depth).map((pass) => {
    const material = new MeshBasicMaterial({ color, transparent: true, side: DoubleSide, toneMapped: false });
    material.opacity = opacity * pass.opacity;
    material.depthWrite = false;
    material.depthTest = depth !== 'in-front';
    if (pass.isBehind) material.depthFunc = GreaterDepth;
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 1;
    object.add(mesh);
    return material;
  });
  return {
    object,
    dispose() {
      letGo(geometry);
      for (const material of materials) material.dispose();
    },
  };
}
