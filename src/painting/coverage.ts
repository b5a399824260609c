import { type BrushTip, falloff } from './brush.ts';

/** What a brush finds around a point: visits each place within a radius once, with its distance. */
export type Around<Point> = (
  point: Point,
  radius: number,
  visit: (place: number, away: number) => void,
) => void;

/**
 * A stroke's effect on the places of what it is painted on. A place that is touched again and again within one stroke gets the
 * most of what the touches give, not their sum: a stroke over itself is no darker.
 */
export class Coverage<Point> {
  /** 0 to 1 for each place. */
  readonly share: Float64Array<ArrayBuffer>;
  readonly #around: Around<Point>;

  /** @param count how many places there are */
  constructor(count: number, around: Around<Point>) {
    this.share = new Float64Array(count);
    this.#around = around;
  }

  /**
   * @param pressure 0 to 1, how hard the brush is pressed
   * @returns places whose share grew
   */
  touch(point: Point, tip: BrushTip, pressure = 1): number[] {
    const grown: number[] = [];
    this.#around(point, tip.radius, (place, away) => {
      if (this.raise(place, pressure * falloff(away, tip))) grown.push(place);
    });
    return grown;
  }

  /** @returns whether the share of a place grew */
  raise(place: number, share: number): boolean {
    if (share <= this.share[place]!) return false;
    this.share[place] = share;
    return true;
  }
}
