import type { Vec3 } from '../../mesh/vectors.ts';
import type { SphereField } from '../../methods/values/sphere-field.ts';

/** The direction of a pixel's centre, unit: see {@link SphereField}. */
export function directionOfPixel(column: number, row: number, height: number): Vec3 {
  const theta = (Math.PI * (row + 0.5)) / height;
  const phi = 2 * Math.PI * ((column + 0.5) / (2 * height) - 0.5);
  return [Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi)];
}

/** What a field says of a direction of any length but zero, as the core reads it. */
export function sampleSphere({ width, height, values }: SphereField, [x, y, z]: Vec3): number {
  const across = (Math.atan2(x, z) / (2 * Math.PI) + 0.5) * width - 0.5;
  const down = (Math.atan2(Math.hypot(x, z), y) / Math.PI) * height - 0.5;
  const [left, top] = [Math.floor(across), Math.floor(down)];
  const along = (row: number) => {
    const from = valueAt(left, row);
    return from + (across - left) * (valueAt(left + 1, row) - from);
  };
  const valueAt = (column: number, row: number): number => {
    if (row >= 0 && row < height) return values[row * width + ((column + width) % width)]!;
    // Beyond a pole the sphere goes on on the other side.
    return valueAt(column + height, row < 0 ? -1 - row : 2 * height - 1 - row);
  };
  const above = along(top);
  return above + (down - top) * (along(top + 1) - above);
}

/** The field that has at each pixel's centre what a function says of its direction. */
export function sphereFieldOf(height: number, of: (direction: Vec3) => number): SphereField {
  const width = 2 * height;
  const values = new Float64Array(width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++)
      values[row * width + column] = of(directionOfPixel(column, row, height));
  return { width, height, values };
}
