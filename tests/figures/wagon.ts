import type { Vec3 } from '../../src/mesh/vectors.ts';
import { extrude } from '../shapes/extruded.ts';
import type { Fineness } from '../shapes/fineness.ts';
import { boxes } from '../shapes/flat.ts';
import { disc } from '../shapes/outline.ts';
import { assembled, type Shape } from '../shapes/shape.ts';
import { Solid } from '../shapes/solid.ts';

/** How far the parts are from each other. */
const gap = 0.04;
const radius = 0.4;

/** Where wheels are, by their names. */
const axles = { rear: 0.9, front: 3.1 } as const;

/** A wagon of six parts that do not touch: a body 4 long, a box on it, and a wheel at each corner. */
export function wagon(fineness: Fineness): Shape {
  const slab = (name: string, min: Vec3, max: Vec3): Shape => {
    const solid = new Solid(fineness);
    boxes(solid, [{ min, max }]);
    return solid.shape(name);
  };
  const wheels = Object.entries(axles).flatMap(([end, x]) =>
    (['near', 'far'] as const).map((side) => [`${end} ${side} wheel`, wheel(fineness, x, side)] as const),
  );
  return assembled('wagon', {
    body: slab('body', [0, 0, 0.45], [4, 1.6, 0.95]),
    box: slab('box', [0.3, 0.15, 0.95 + gap], [2.4, 1.45, 1.6]),
    ...Object.fromEntries(wheels),
  });
}

function wheel(fineness: Fineness, x: number, side: 'near' | 'far'): Shape {
  const solid = new Solid(fineness);
  const front = side === 'near' ? -gap : 1.6 + gap + 0.3;
  extrude(solid, {
    outline: disc([0, 0], radius),
    low: -0.3,
    high: 0,
    place: ([a, b, h]) => [x + a, front - 0.3 - h, radius + b],
  });
  solid.round('rim', ([a, , c]) => Math.abs(Math.hypot(a - x, c - radius) - radius) < 1e-6, [0, 1, 0]);
  return solid.shape('wheel');
}
