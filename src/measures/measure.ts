import type { Mesh } from '../mesh/mesh.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { Scale } from './scale.ts';

/** What can be measured of, as plain data. */
export interface Measured {
  readonly mesh: Mesh;
  /** The shape that it has now, #P×3; null while nothing was done to it. */
  readonly positions: Float64Array | null;
  /** What normals are drawn to; null where nothing tells. */
  readonly targets: NormalTargets | null;
  /** λ of each position, #P; null where there is only the one λ. */
  readonly strengths: ArrayLike<number> | null;
  /** What the method itself knows of the shape. */
  readonly fields: readonly (ScalarField | LineField)[];
}

/** A number for each position or face that a method tells besides the shape. */
export interface ScalarField {
  readonly name: string;
  readonly label: string;
  readonly per: 'vertex' | 'face';
  /** As shown to people, '' for a pure number; × for factors. */
  readonly unit: string;
  /** #P, or #F. */
  readonly values: Float64Array;
}

/** Lines over the mesh that a method tells besides the shape: creases that it found, and the like. */
export interface LineField {
  readonly name: string;
  readonly label: string;
  readonly per: 'line';
  /** Positions of the file, two for each line. */
  readonly values: Float64Array;
}

/** A style, and whose normals its targets are looked up from. */
export interface NormalTargets {
  readonly map: GaussMap;
  /** #P×3: the shape that the targets were looked up from once; null where they follow the shape that there is now. */
  readonly from: Float64Array | null;
}

/** What the colours on the mesh can show; `none` is the clay or the file's own colours. */
export type OverlayName =
  | 'none'
  | 'angle-before'
  | 'angle-after'
  | 'curvature-before'
  | 'curvature-after'
  | 'movement'
  | 'growth'
  | 'turn'
  | 'strength'
  | `field-${string}`;

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
  /** The measure of the same thing before anything was done, to be shown with the file's own shape. */
  readonly before?: Measure['name'];
  /** Whether it makes sense here. */
  readonly suits: (measured: Measured) => boolean;
  /** Measures what it suits. */
  readonly of: (measured: Measured) => Overlay;
}

/** The shape that there is now. */
export function positionsNow({ mesh, positions }: Measured): Float64Array {
  return positions ?? mesh.positions;
}
