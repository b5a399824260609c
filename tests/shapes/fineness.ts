import { evenFill, type Filled, fanFill } from './fill.ts';
import type { Loop } from './plane.ts';

/** How finely a shape is meshed, and in which manner. */
export interface Fineness {
  /** Number of pieces that a straight line is cut into. */
  line(length: number): number;
  /** Number of pieces of an arc of so many radians. */
  arc(radius: number, angle: number): number;
  /** Whether a bent side is a strip of quads cut in two, as programs for construction have it. */
  readonly strips: boolean;
  /** Triangles between loops whose sides are such pieces. */
  fill(loops: readonly Loop[]): Filled;
}

/** Even triangles of about the same edges, as a remesher makes them. Whole turns have twelve pieces or more. */
export function even(edge: number): Fineness {
  const line = (length: number): number => Math.max(1, Math.round(length / edge - 1e-6)); // equal lengths stay equal
  return {
    line,
    arc: (radius, angle) => Math.max(line(radius * angle), Math.ceil((6 * angle) / Math.PI - 1e-9)),
    strips: false,
    fill: (loops) => evenFill(loops, edge),
  };
}

/** As it comes from a program for construction: no vertex but where the outline needs one, a strip for each fillet. */
export function raw(piecesPerTurn = 32): Fineness {
  return {
    line: () => 1,
    arc: (_, angle) => Math.max(1, Math.round((piecesPerTurn * angle) / (2 * Math.PI))),
    strips: true,
    fill: fanFill,
  };
}
