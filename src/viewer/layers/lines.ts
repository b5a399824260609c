import { GreaterDepth, Group, Vector2 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { Surface } from '../surface.ts';
import type { DrawnLayer, LinesLayer } from './layer.ts';
import { passesOf } from './passes.ts';

/** Lines of a width in pixels. */
export function drawLines(layer: LinesLayer, surface: Surface): DrawnLayer {
  const geometry = new LineSegmentsGeometry();
  const ends = endsOf(layer, surface);
  geometry.setPositions(ends);
  const object = new Group();
  const materials = passesOf(layer.depth).map(({ opacity, isBehind }) => {
    const material = new LineMaterial({ color: layer.color, linewidth: layer.width, transparent: true });
    material.opacity = opacity;
    material.depthWrite = false;
    material.depthTest = layer.depth !== 'in-front';
    if (isBehind) material.depthFunc = GreaterDepth;
    const lines = new LineSegments2(geometry, material);
    lines.frustumCulled = false;
    lines.renderOrder = 2;
    object.add(lines);
    return material;
  });
  return {
    object,
    follow(moved) {
      if (layer.positions) geometry.setPositions(endsOf(layer, moved, ends));
    },
    resize(width, height) {
      for (const material of materials) material.resolution = new Vector2(width, height);
    },
    dispose() {
      geometry.dispose();
      for (const material of materials) material.dispose();
    },
  };
}

/** Both ends of each line in view units, #lines×6. */
function endsOf({ positions, places }: LinesLayer, surface: Surface, into?: Float32Array): Float32Array {
  if (!positions) return toView(places ?? [], surface);
  const ends = into ?? new Float32Array(3 * positions.length);
  const { drawn } = surface;
  for (let k = 0; k < positions.length; k++) {
    const from = 3 * positions[k]!;
    ends[3 * k] = drawn[from]!;
    ends[3 * k + 1] = drawn[from + 1]!;
    ends[3 * k + 2] = drawn[from + 2]!;
  }
  return ends;
}

/** Places of the file's frame (#×3) in view units. */
export function toView(places: ArrayLike<number>, { frame: { center, scale } }: Surface): Float32Array {
  return Float32Array.from(places, (value, k) => (value - center[k % 3]!) * scale);
}
