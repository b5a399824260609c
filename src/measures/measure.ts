import type { WhittleDocument } from '../editor/project.ts';
import type { Scale } from './scale.ts';

/** What the colours on the mesh can show; `none` is the clay or the file's own colours. */
export type OverlayName =
  | 'none'
  | 'angle-before'
  | 'angle-after'
  | 'curvature-before'
  | 'curvature-after'
  | 'movement'
  | 'growth'
  | 'strength';

/** A number for every position of the mesh, to be shown as colours. */
export interface Overlay {
  readonly title: string;
  /** The whole of it in a few words: a mean, a range, a share. */
  readonly summary: string;
  readonly scale: Scale;
  /** #P; NaN where there is nothing to measure. */
  readonly values: Float32Array<ArrayBuffer>;
  /** What is meant by an absence of colour; only where some values are NaN. */
  readonly blank?: string;
  /** A sentence to judge the result by. */
  readonly verdict?: string;
}

/** One way to look closer. */
export interface Measure {
  readonly name: Exclude<OverlayName, 'none'>;
  /** In the panel, where there is little room. */
  readonly label: string;
  /** Of the same thing before anything was done, to be shown with the file's own shape. */
  readonly before?: Measure['name'];
  /** Whether it makes sense of this document. */
  readonly suits: (document: WhittleDocument) => boolean;
  /** Measures a document that it suits. */
  readonly of: (document: WhittleDocument) => Overlay;
}

/** The diagonal of the file's box: what lengths are told in. */
export function sizeOf({ report: { min, max } }: WhittleDocument): number {
  return Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]) || 1;
}
