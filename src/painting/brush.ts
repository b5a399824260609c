import { between, distance, type Vec3 } from '../mesh/vectors.ts';

/** The end of a brush that touches a surface. */
export interface BrushTip {
  /** In units of the surface. */
  readonly radius: number;
  /** 0 fades from the middle on, 1 is full up to the rim. */
  readonly hardness: number;
}

/** How much a brush gives at a distance from its middle: 1 inside its hard core, smoothly down to 0 at its radius. */
export function falloff(away: number, { radius, hardness }: BrushTip): number {
  const core = radius * Math.min(0.999, Math.max(0, hardness));
  if (away <= core) return 1;
  if (away >= radius) return 0;
  const t = (radius - away) / (radius - core);
  return t * t * (3 - 2 * t);
}

/** Turns the points where a pointer was seen into touches that overlap, however quickly it moved. */
export class Stroke {
  readonly #spacing: number;
  #last: Vec3 | null = null;

  /** @param spacing most there may be between two touches */
  constructor(spacing: number) {
    this.#spacing = spacing;
  }

  /** The touches that lead to a point, itself the last. */
  to(point: Vec3): Vec3[] {
    const from = this.#last ?? point;
    this.#last = point;
    const steps = Math.max(1, Math.ceil(distance(from, point) / this.#spacing));
    return Array.from({ length: steps }, (_, k) => between(from, point, (k + 1) / steps));
  }
}
