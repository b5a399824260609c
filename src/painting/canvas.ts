import type { Around } from './coverage.ts';

/** Something that a field from 0 to 1 is painted on: its places, by number, and who neighbours whom. */
export interface FieldCanvas<Point> {
  /** How many places there are. */
  readonly count: number;
  readonly around: Around<Point>;
  /** Visits the neighbours of a place. */
  readonly neighbours: (place: number, visit: (neighbour: number) => void) => void;
  /** The place in the mirror, undefined where there is none. Absent: nothing is mirrored. */
  readonly partner?: (place: number) => number | undefined;
}
