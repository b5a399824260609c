import { type Combination, defaultFeatureAngle, type Selection } from '../../src/selection/index.ts';

/** How one selects: what is pointed at, with a brush, by a line around, by a frame. */
export type SelectWay = 'click' | 'brush' | 'lasso' | 'box';

/** What is selected and how; never undone. */
export interface SelectState {
  readonly way: SelectWay;
  /** What becomes of what is selected already; keys held down come before it. */
  readonly combination: Combination;
  /** What is hidden is taken as well. */
  readonly through: boolean;
  /** Radius of the brush in CSS pixels. */
  readonly brush: number;
  /** Degrees by which an edge bends at least that ends a smooth patch. */
  readonly angle: number;
  /** Null while there is no mesh. */
  readonly selection: Selection | null;
  /** On a phone, where there is little room, all options are shown. */
  readonly isUnfolded: boolean;
  /** What a click would take. */
  readonly pointed: string | null;
  /** What is to be said of the last thing that was done. */
  readonly remark: string | null;
}

export const brushSizes = { least: 6, most: 120 } as const;

export const startingSelect: SelectState = Object.freeze({
  way: 'click',
  combination: 'replace',
  through: false,
  brush: 28,
  angle: defaultFeatureAngle,
  isUnfolded: false,
  selection: null,
  pointed: null,
  remark: null,
});
