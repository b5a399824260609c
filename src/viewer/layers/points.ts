import { BufferAttribute, BufferGeometry, Color, GreaterDepth, Group, Points, ShaderMaterial } from 'three';
import type { Surface } from '../surface.ts';
import type { DrawnLayer, PointsLayer } from './layer.ts';
import { letGo, passesOf } from './passes.ts';

/** Dots over the surface's own buffer of positions: they move with it at no cost. */
export function drawPoints(layer: PointsLayer, surface: Surface): DrawnLayer {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', surface.geometry.getAttribute('position'));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(layer.positions), 1));
  const object = new Group();
  const materials = passesOf(layer.depth).map(({ opacity, isBehind }) => {
    const material = dots(layer, opacity);
    material.depthTest = layer.depth !== 'in-front';
    if (isBehind) material.depthFunc = GreaterDepth;
    const points = new Points(geometry, material);
    points.frustumCulled = false;
    points.renderOrder = 3;
    object.add(points);
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

/** Round dots with a rim, a little nearer than they are so that the surface they lie on does not cut them. */
function dots({ color, size }: PointsLayer, opacity: number): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: {
      color: { value: new Color(color) },
      size: { value: size * Math.min(2, globalThis.devicePixelRatio ?? 1) },
      opacity: { value: opacity },
    },
    vertexShader: `
      uniform float size;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_Position.z -= 0.0006 * gl_Position.w;
        gl_PointSize = size;
      }`,
    fragmentShader: `
      uniform vec3 color;
      uniform float opacity;
      void main() {
        float away = 2.0 * length(gl_PointCoord - 0.5);
        float inside = 1.0 - smoothstep(0.85, 1.0, away);
        if (inside <= 0.0) discard;
        gl_FragColor = vec4(mix(color, vec3(1.0), 0.75 * smoothstep(0.6, 0.75, away)), inside * opacity);
        #include <colorspace_fragment>
      }`,
  });
}
