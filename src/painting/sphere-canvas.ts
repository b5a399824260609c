import { directionOfPixel } from '../inputs/fields/sphere-field.ts';
import type { Vec3 } from '../mesh/vectors.ts';
import type { FieldCanvas } from './canvas.ts';

/** The pixels of a `SphereField` under a brush; points are unit directions, distances angles in radians. */
export class SphereCanvas implements FieldCanvas<Vec3> {
  readonly height: number;
  readonly count: number;
  readonly partner?: (place: number) => number;
  /** #pixels×3. */
  readonly #directions: Float64Array;

  /** @param mirrored whether left and right of the plane x = 0 are painted alike */
  constructor(height: number, mirrored = false) {
    const width = 2 * height;
    this.height = height;
    this.count = width * height;
    this.#directions = new Float64Array(3 * this.count);
    for (let place = 0; place < this.count; place++)
      this.#directions.set(directionOfPixel(place % width, Math.floor(place / width), height), 3 * place);
    // x changes its sign as columns are counted from the other side.
    if (mirrored) this.partner = (place) => place - (place % width) + (width - 1 - (place % width));
  }

  readonly around = ([x, y, z]: Vec3, radius: number, visit: (place: number, away: number) => void): void => {
    const at = this.#directions;
    const least = radius < Math.PI ? Math.cos(radius) : -2;
    for (let place = 0; place < this.count; place++) {
      const cosine = x * at[3 * place]! + y * at[3 * place + 1]! + z * at[3 * place + 2]!;
      if (cosine > least) visit(place, Math.acos(Math.min(1, Math.max(-1, cosine))));
    }
  };

  /** Left, right, above and below; over a pole the one on the other side. */
  readonly neighbours = (place: number, visit: (neighbour: number) => void): void => {
    const width = 2 * this.height;
    const [column, row] = [place % width, Math.floor(place / width)];
    const across = row * width + ((column + this.height) % width);
    visit(row * width + ((column + 1) % width));
    visit(row * width + ((column + width - 1) % width));
    visit(row === 0 ? across : place - width);
    visit(row === this.height - 1 ? across : place + width);
  };
}
