import { WhittleError } from '../../mesh/failure.ts';
import { add, length, row, scale, unit, type Vec3 } from '../../mesh/vectors.ts';
import type { GaussMap } from '../../methods/values/gauss-map.ts';
import { lookup } from './gauss-lookup.ts';
import { icosphere } from './icosphere.ts';

/**
 * Normal captures (2021, §3.1 and Fig. 17): a style as a square picture of a ball, as a MatCap is one of a shaded ball.
 *
 * The ball fills the square. With x to the right and y up, both from −1 to 1, the pixel at (x, y) is the sphere's point
 * (x, y, √(1 − x² − y²)), seen by someone who looks along −z. Its colour is the target normal t there: R, G, B = (t + 1) / 2
 * of full brightness, for x, y, z. The half of the sphere that is not seen is the mirror image of the one that is:
 * t(x, y, −z) = (t_x, t_y, −t_z).
 */
export interface CapturePixels {
  readonly width: number;
  readonly height: number;
  /** RGBA, rows from the top, 4·width·height bytes. */
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** A Gauss map on the sphere that all captures share, one target per point. */
export type SphereMap = Extract<GaussMap, { kind: 'sphere' }>;

/** Edges of 2°: finer than the pixels of a capture of 100. */
const halvings = 5;
const smallest = 16;
const largest = 4096;
/** Colours this near to a unit vector's are read as one. */
const unitTolerance = 0.15;
/** So much of the ball must be normals. */
const leastShare = 0.9;

/** A map that wants `target(p)` where the input's normal is p. */
export function sphereMap(target: (normal: Vec3) => Vec3): SphereMap {
  const { points, triangles } = icosphere(halvings);
  const normals = new Float64Array(points.length);
  for (let v = 0; 3 * v < points.length; v++) normals.set(target(row(points, v)), 3 * v);
  return { kind: 'sphere', points, triangles, normals, per: 'vertex' };
}

/** True for maps on the captures' own sphere, which can be painted point by point. */
export function isSphereMap(map: GaussMap): map is SphereMap {
  return map.kind === 'sphere' && map.per === 'vertex' && map.points === icosphere(halvings).points;
}

/** Any style on the captures' sphere. */
export function onSphere(map: GaussMap): SphereMap {
  return isSphereMap(map) ? map : sphereMap(lookup(map));
}

/** Wants every normal as it is: an empty canvas. */
export function blankMap(): SphereMap {
  return sphereMap((normal) => normal);
}

/**
 * Reads a capture.
 *
 * @throws WhittleError `unsupported-file` if the picture is not square, too small or large, or its ball is not of normals
 */
export function mapOfPixels(pixels: CapturePixels): SphereMap {
  requireCapture(pixels);
  const reach = reachOf(pixels);
  return sphereMap(([x, y, z]) => {
    const [tx, ty, tz] = sample(pixels, reach, x, y);
    return [tx, ty, z < 0 ? -tz : tz];
  });
}

/** Draws a capture of the front half of a map. Outside the ball it is see-through, but for a rim of two pixels. */
export function pixelsOfMap(map: GaussMap, size: number): CapturePixels {
  const data = new Uint8ClampedArray(4 * size * size);
  const target = lookup(map);
  for (let j = 0; j < size; j++)
    for (let i = 0; i < size; i++) {
      const [x, y] = place(i, j, size);
      const radius = Math.hypot(x, y);
      if (radius > 1 + 4 / size) continue;
      const z = Math.sqrt(Math.max(0, 1 - radius * radius));
      const color = colorOf(target(unit([x, y, z])));
      data.set([...color, 255], 4 * (j * size + i));
    }
  return { width: size, height: size, data };
}

/** A normal as a colour, from 0 to 255. */
export function colorOf(normal: Vec3): Vec3 {
  return scale(add(normal, [1, 1, 1]), 127.5);
}

function place(i: number, j: number, size: number): [number, number] {
  return [(2 * (i + 0.5)) / size - 1, 1 - (2 * (j + 0.5)) / size];
}

/** The vector of a pixel, of any length; undefined if it is see-through. */
function vectorAt({ data, width }: CapturePixels, i: number, j: number): Vec3 | undefined {
  const at = 4 * (j * width + i);
  if (data[at + 3]! < 128) return undefined;
  return [data[at]! / 127.5 - 1, data[at + 1]! / 127.5 - 1, data[at + 2]! / 127.5 - 1];
}

function isUnit(vector: Vec3 | undefined): vector is Vec3 {
  return vector !== undefined && Math.abs(length(vector) - 1) <= unitTolerance;
}

/**
 * How far from the middle pixels count, as a share of the ball's radius: beyond its rim too, where there is nothing that could be
 * taken for a normal, and not where the ground is of such a colour (the flat blue of normal maps is one).
 */
function reachOf(pixels: CapturePixels): number {
  const last = pixels.width - 1;
  const isGroundNormal = [0, last].some((i) => [0, last].some((j) => isUnit(vectorAt(pixels, i, j))));
  return isGroundNormal ? 1 : Number.POSITIVE_INFINITY;
}

/** Between the four pixels around a point; those that are no normals (the background) or out of reach do not count. */
function sample(pixels: CapturePixels, reach: number, x: number, y: number): Vec3 {
  const size = pixels.width;
  const u = ((x + 1) * size) / 2 - 0.5;
  const v = ((1 - y) * size) / 2 - 0.5;
  let sum: Vec3 = [0, 0, 0];
  for (const [i, j] of around(u, v)) {
    const isThere = i >= 0 && j >= 0 && i < size && j < size && Math.hypot(...place(i, j, size)) <= reach;
    const vector = isThere ? vectorAt(pixels, i, j) : undefined;
    const share = (1 - Math.abs(u - i)) * (1 - Math.abs(v - j));
    if (isUnit(vector)) sum = add(sum, scale(vector, share));
  }
  if (length(sum) > 1e-6) return unit(sum);
  // A hole: a little nearer to the middle there is something.
  return Math.hypot(x, y) < 1 / size ? [0, 0, 1] : sample(pixels, reach, x * 0.98, y * 0.98);
}

function around(u: number, v: number): [number, number][] {
  const [i, j] = [Math.floor(u), Math.floor(v)];
  return [
    [i, j],
    [i + 1, j],
    [i, j + 1],
    [i + 1, j + 1],
  ];
}

function requireCapture(pixels: CapturePixels): void {
  const { width, height } = pixels;
  const refuse = (why: string): never => {
    throw new WhittleError('unsupported-file', why);
  };
  if (width !== height)
    refuse(
      `The picture has ${width} × ${height} pixels, but a normal capture is square; crop it to the square around the ball.`,
    );
  if (width < smallest || width > largest)
    refuse(
      `The picture is ${width} pixels wide; a normal capture has from ${smallest} to ${largest}. Scale it, 256 are plenty.`,
    );
  const share = shareOfNormals(pixels);
  if (share < leastShare)
    refuse(
      `Only ${Math.floor(100 * share)} % of the ball in this picture are normals (red, green, blue as x, y, z around mid grey). ` +
        'Drop a ball rendered with a normal material; a photo or a shaded MatCap has no normals to read.',
    );
}

/** The share of normals among the pixels of the ball. */
function shareOfNormals(pixels: CapturePixels): number {
  const size = pixels.width;
  let all = 0;
  let good = 0;
  for (let j = 0; j < size; j++)
    for (let i = 0; i < size; i++) {
      if (Math.hypot(...place(i, j, size)) > 1 - 2 / size) continue;
      all++;
      if (isUnit(vectorAt(pixels, i, j))) good++;
    }
  return good / all;
}
