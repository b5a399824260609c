import { type BrushTip, falloff } from './brush.ts';
import type { FieldCanvas } from './canvas.ts';
import { Coverage } from './coverage.ts';

/** What a brush does to the field under it. */
export type FieldOperation = 'add' | 'subtract' | 'set' | 'smooth' | 'erase';

export interface FieldBrush extends BrushTip {
  readonly operation: FieldOperation;
  /** How much a full touch does, 0 to 1: what is added or taken away, or the share of the way to what is set. */
  readonly strength: number;
  /** What `set` brings the field to, 0 to 1. */
  readonly value: number;
}

/** What a field is where nobody has painted: all of it is there. `erase` brings it back. */
export const unpainted = 1;

/** One stroke of a brush over a field. The field that it began with stays as it was. */
export class FieldStroke<Point> {
  /** The field as the stroke has left it so far; a live view. */
  readonly values: Float64Array<ArrayBuffer>;
  readonly #canvas: FieldCanvas<Point>;
  readonly #base: Float64Array;
  readonly #brush: FieldBrush;
  readonly #coverage: Coverage<Point>;

  /** @param base a number from 0 to 1 for each place */
  constructor(canvas: FieldCanvas<Point>, base: Float64Array, brush: FieldBrush) {
    this.#canvas = canvas;
    this.#base = base;
    this.#brush = brush;
    this.#coverage = new Coverage(canvas.count, canvas.around);
    this.values = base.slice();
  }

  /**
   * Touches with the brush, and on a canvas with a mirror with its image.
   *
   * @param pressure 0 to 1, that of a pen
   * @returns places whose number may have changed
   */
  touch(point: Point, pressure = 1): readonly number[] {
    return this.#brush.operation === 'smooth' ? this.#smooth(point, pressure) : this.#cover(point, pressure);
  }

  #cover(point: Point, pressure: number): readonly number[] {
    const { share } = this.#coverage;
    const { partner } = this.#canvas;
    const changed = this.#coverage.touch(point, this.#brush, pressure);
    for (let k = changed.length - 1; partner && k >= 0; k--) {
      const other = partner(changed[k]!);
      if (other !== undefined && this.#coverage.raise(other, share[changed[k]!]!)) changed.push(other);
    }
    for (const place of changed) this.values[place] = painted(this.#base[place]!, share[place]!, this.#brush);
    return changed;
  }

  /** Brings each place nearer to the mean of its neighbours. Touches add up here, or nothing would ever be smooth. */
  #smooth(point: Point, pressure: number): readonly number[] {
    const brush = this.#brush;
    const { around, partner } = this.#canvas;
    const { share } = this.#coverage;
    const places: number[] = [];
    const take = (place: number | undefined, by: number) => {
      if (place === undefined || by === 0) return;
      if (share[place] === 0) places.push(place);
      share[place] = Math.max(share[place]!, by);
    };
    around(point, brush.radius, (place, away) => {
      const by = pressure * brush.strength * falloff(away, brush);
      take(place, by);
      if (partner) take(partner(place), by);
    });
    const means = places.map((place) => this.#meanAround(place));
    for (const [k, place] of places.entries()) {
      this.values[place]! += share[place]! * (means[k]! - this.values[place]!);
      share[place] = 0; // for the next touch
    }
    return places;
  }

  #meanAround(place: number): number {
    let sum = 0;
    let count = 0;
    this.#canvas.neighbours(place, (neighbour) => {
      sum += this.values[neighbour]!;
      count++;
    });
    return count > 0 ? sum / count : this.values[place]!;
  }
}

/** What a share of a touch makes of a number. */
function painted(base: number, share: number, { operation, strength, value }: FieldBrush): number {
  const by = share * strength;
  if (operation === 'add') return Math.min(1, base + by);
  if (operation === 'subtract') return Math.max(0, base - by);
  const goal = operation === 'erase' ? unpainted : value;
  return base + by * (goal - base);
}
