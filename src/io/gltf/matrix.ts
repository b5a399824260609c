/** 4×4 matrices as glTF has them: 16 numbers, column by column. */
export type Matrix = readonly number[];

export const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export function multiply(a: Matrix, b: Matrix): Matrix {
  return identity.map((_, i) => {
    const row = i % 4;
    const column = i - row;
    let sum = 0;
    for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[column + k];
    return sum;
  });
}

/** Translation, rotation (quaternion x y z w, any length) and scale as a matrix. */
export function compose(t: readonly number[], q: readonly number[], s: readonly number[]): Matrix {
  const length = Math.hypot(...q);
  const [x, y, z, w] = length > 0 ? q.map((value) => value / length) : [0, 0, 0, 1];
  const columns = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  return [...columns.flatMap((column, i) => [...column.map((value) => value * s[i]), 0]), ...t, 1];
}

export function sameMatrix(a: Matrix, b: Matrix): boolean {
  return a.every((value, i) => value === b[i]);
}

/** The 3×3 part as columns, row-major reading of its transpose: what normals are multiplied with on the way back. */
export function linearPart(m: Matrix): number[] {
  return [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];
}

/** Whether a matrix mirrors: its determinant is below 0. */
export function isMirrored(m: Matrix): boolean {
  const [a, b, c, d, e, f, g, h, i] = linearPart(m);
  return a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e) < 0;
}

/** Inverse of a 3×3 matrix (columns), or undefined if it flattens space. */
export function invert3(m: readonly number[]): number[] | undefined {
  const [a, b, c, d, e, f, g, h, i] = m;
  const A = e * i - f * h;
  const B = f * g - d * i;
  const C = d * h - e * g;
  const determinant = a * A + b * B + c * C;
  const size = Math.max(...m.map(Math.abs)) ** 3;
  if (!(Math.abs(determinant) > 1e-14 * size)) return undefined;
  const inverse = [
    A,
    c * h - b * i,
    b * f - c * e,
    B,
    a * i - c * g,
    c * d - a * f,
    C,
    b * g - a * h,
    a * e - b * d,
  ];
  return inverse.map((value) => value / determinant);
}

/** Columns `m` times (x, y, z) into `into[at…]`. */
export function apply3(
  m: readonly number[],
  x: number,
  y: number,
  z: number,
  into: Float64Array,
  at: number,
): void {
  for (let row = 0; row < 3; row++) into[at + row] = m[row] * x + m[3 + row] * y + m[6 + row] * z;
}

/** The transpose of columns `m` times (x, y, z) into `into[at…]`. */
export function applyTransposed3(
  m: readonly number[],
  x: number,
  y: number,
  z: number,
  into: Float64Array,
  at: number,
): void {
  for (let row = 0; row < 3; row++) into[at + row] = m[3 * row] * x + m[3 * row + 1] * y + m[3 * row + 2] * z;
}
