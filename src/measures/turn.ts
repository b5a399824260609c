import { dot, doubledAreaVector, length, row, unit, type Vec3 } from '../mesh/vectors.ts';
import { solvedSourceTriangles } from '../mesh/weld.ts';
import { type Measure, type Measured, positionsNow } from './measure.ts';
import { mean, quantile } from './statistics.ts';

/** The angle between where the surface looks now and where it looked in the file: what tilts, bends or dents shows. */
export const turn: Measure = {
  name: 'turn',
  label: 'Tilt',
  suits: ({ positions }) => positions !== null,
  of: (measured) => {
    const values = turns(measured);
    const most = quantile(values, 1);
    return {
      title: 'How far the surface tilted',
      summary: `on average ${mean(values).toPrecision(3)}°, ${most.toPrecision(3)}° at most`,
      scale: { kind: 'rising', end: ends.find((end) => end >= most) ?? ends.at(-1)!, unit: '°' },
      values,
      ...(values.some(Number.isNaN) ? { blank: 'no face' } : {}),
    };
  },
};

/** Where the band may end, in degrees. */
const ends = [1, 2, 5, 10, 20, 45, 90];

/** In degrees, #P: the most that any of the faces around a place tilted, so that a flat side beside an edge shows as flat. NaN where there is none. */
function turns(measured: Measured): Float32Array<ArrayBuffer> {
  const { mesh } = measured;
  const before = mesh.positions;
  const now = positionsNow(measured);
  const values = new Float32Array(before.length / 3).fill(Number.NaN);
  const faces = solvedSourceTriangles(mesh);
  for (let face = 0; face < faces.length; face += 3) {
    const corners = faces.subarray(face, face + 3);
    const angle = angleBetween(normalOf(before, corners), normalOf(now, corners));
    for (const p of corners) if (!(values[p]! >= angle)) values[p] = angle;
  }
  return values;
}

function normalOf(positions: Float64Array, [a, b, c]: Uint32Array): Vec3 {
  return unit(doubledAreaVector(row(positions, a!), row(positions, b!), row(positions, c!)));
}

/** In degrees; NaN where one of them has no direction. */
function angleBetween(a: Vec3, b: Vec3): number {
  const cosine = dot(a, b);
  if (length(a) === 0 || length(b) === 0) return Number.NaN;
  return (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
}
