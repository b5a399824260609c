import type { Object3D } from 'three';
import type { Surface } from '../surface.ts';

/** How a layer is seen behind the surface: as if it were before it, faintly, or not at all. */
export type Depth = 'in-front' | 'faint-behind' | 'hidden-behind';

interface Paint {
  /** CSS colour. */
  readonly color: string;
  readonly depth: Depth;
}

/** Dots. */
export interface PointsLayer extends Paint {
  readonly kind: 'points';
  /** Positions of the file; the dots stay on the surface as it moves. */
  readonly positions: ArrayLike<number>;
  /** Diameter in CSS pixels. */
  readonly size: number;
}

/** Separate lines. */
export interface LinesLayer extends Paint {
  readonly kind: 'lines';
  /** Two positions of the file for each line, which stays on the surface, … */
  readonly positions?: ArrayLike<number>;
  /** … or two places (#lines×2×3) in the file's frame. */
  readonly places?: ArrayLike<number>;
  /** In CSS pixels. */
  readonly width: number;
}

/** Triangles of the surface, tinted. */
export interface FacesLayer extends Paint {
  readonly kind: 'faces';
  /** Three positions of the file for each triangle. */
  readonly corners: Uint32Array;
  readonly opacity: number;
}

/** Lines with a head. */
export interface ArrowsLayer extends Paint {
  readonly kind: 'arrows';
  /** #arrows×3 in the file's frame. */
  readonly from: ArrayLike<number>;
  readonly to: ArrayLike<number>;
  /** In CSS pixels. */
  readonly width: number;
}

/** Translucent squares that stand in space. */
export interface SheetLayer extends Paint {
  readonly kind: 'sheet';
  /** In the file's frame and units. */
  readonly center: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
  /** Half of a side, in the file's units. */
  readonly reach: number;
  readonly opacity: number;
}

export type Layer = PointsLayer | LinesLayer | FacesLayer | ArrowsLayer | SheetLayer;

/** A layer on the scene. */
export interface DrawnLayer {
  readonly object: Object3D;
  /** The surface has other positions. */
  follow?(surface: Surface): void;
  /** The canvas has another size, in CSS pixels. */
  resize?(width: number, height: number): void;
  dispose(): void;
}
