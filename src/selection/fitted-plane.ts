import { dot, row, unit, type Vec3 } from '../mesh/vectors.ts';

/** The plane normal·x = offset. */
export interface FittedPlane {
  /** Of length 1; its largest coordinate is positive. */
  readonly normal: Vec3;
  /** In file units. */
  readonly offset: number;
  /** The middle of the places, which lies on it. */
  readonly center: Vec3;
}

/** A plane that is off an axis of the file by no more degrees is meant to lie across it: what is taken by eye is askew. */
const snapAngle = 15;

/**
 * The plane that some places lie nearest to (least squares), across an axis of the file where it nearly is. Places that do not tell
 * which way it lies (one, or some on a line) get the axis along which they spread least, the last of those that are equal.
 *
 * @param places #P×3   @param which of them, one or more
 */
export function fittedPlane(places: ArrayLike<number>, which: ArrayLike<number>): FittedPlane {
  const center = middleOf(places, which);
  const spread = spreadOf(places, which, center);
  const normal = snapped(leastAxis(spread), spread);
  return { normal, offset: dot(normal, center), center };
}

/** How far some places reach from a centre. */
export function reachOf(places: ArrayLike<number>, which: ArrayLike<number>, [x, y, z]: Vec3): number {
  let most = 0;
  for (let k = 0; k < which.length; k++) {
    const [px, py, pz] = row(places, which[k]!);
    most = Math.max(most, (px - x) ** 2 + (py - y) ** 2 + (pz - z) ** 2);
  }
  return Math.sqrt(most);
}

function middleOf(places: ArrayLike<number>, which: ArrayLike<number>): Vec3 {
  const sum: [number, number, number] = [0, 0, 0];
  for (let k = 0; k < which.length; k++)
    for (let axis = 0; axis < 3; axis++) sum[axis]! += places[3 * which[k]! + axis]!;
  return [sum[0] / which.length, sum[1] / which.length, sum[2] / which.length];
}

/** The sums of products of distances from the centre, symmetric 3×3. */
type Spread = [Triple, Triple, Triple];
type Triple = [number, number, number];

function spreadOf(places: ArrayLike<number>, which: ArrayLike<number>, center: Vec3): Spread {
  const spread: Spread = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]; // biome-ignore format: a matrix
  for (let k = 0; k < which.length; k++) {
    const place = row(places, which[k]!);
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++) spread[i]![j]! += (place[i]! - center[i]!) * (place[j]! - center[j]!);
  }
  return spread;
}

/** The direction along which there is the least spread: of the smallest eigenvalue, by Jacobi's rotations. */
function leastAxis(spread: Spread): Vec3 {
  const a = spread.map((line) => [...line]) as Spread;
  const vectors: Spread = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; // biome-ignore format: a matrix
  const size = a[0][0] + a[1][1] + a[2][2];
  for (let sweep = 0; sweep < 30; sweep++) {
    if (Math.abs(a[0][1]) + Math.abs(a[0][2]) + Math.abs(a[1][2]) <= 1e-15 * size) break;
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]] as const) rotate(a, vectors, p, q); // biome-ignore format: pairs
  }
  // The last of those that are equal, as with places that do not tell.
  let least = 2;
  for (const axis of [1, 0] as const) if (a[axis]![axis]! < a[least]![least]! - 1e-12 * size) least = axis;
  return [vectors[0][least]!, vectors[1][least]!, vectors[2][least]!];
}

/** Turns the axes p and q so that nothing is left between them. */
function rotate(a: Spread, vectors: Spread, p: 0 | 1, q: 1 | 2): void {
  if (a[p][q] === 0) return;
  const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
  const c = 1 / Math.sqrt(t * t + 1);
  const s = t * c;
  for (let k = 0; k < 3; k++) {
    const [kp, kq] = [a[k]![p], a[k]![q]];
    a[k]![p] = c * kp - s * kq;
    a[k]![q] = s * kp + c * kq;
  }
  for (let k = 0; k < 3; k++) {
    const [pk, qk] = [a[p][k]!, a[q][k]!];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
    const [vp, vq] = [vectors[k]![p], vectors[k]![q]];
    vectors[k]![p] = c * vp - s * vq;
    vectors[k]![q] = s * vp + c * vq;
  }
}

function snapped(normal: Vec3, spread: Spread): Vec3 {
  const size = spread[0][0] + spread[1][1] + spread[2][2];
  const along = (axis: Vec3) => spread.reduce((sum, line, i) => sum + axis[i]! * dot(line, axis), 0);
  const least = along(normal);
  for (const axis of axes) {
    const isNear = Math.abs(dot(axis, normal)) >= Math.cos((snapAngle * Math.PI) / 180);
    if (isNear || along(axis) <= least + 1e-9 * size) return axis;
  }
  const largest = normal.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), 0);
  return unit(largest < 0 ? [-normal[0], -normal[1], -normal[2]] : normal);
}

/** The last comes first: of places that do not tell, a plane across z is as good as any. */
const axes: readonly Vec3[] = [[0, 0, 1], [0, 1, 0], [1, 0, 0]]; // biome-ignore format: a matrix
