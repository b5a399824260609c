import type { Look } from './look/look.ts';

/** What every reader hands on: the shape as the file has it, before polygons are split. */

/** Polygons, one after the other. */
export interface Faces {
  /** #F+1: where each face begins in `corners`; the last entry is #C. */
  readonly start: Uint32Array<ArrayBuffer>;
  /** #C indices into the positions. */
  readonly corners: Uint32Array<ArrayBuffer>;
}

/** An image inside a mesh file. */
export interface EmbeddedImage {
  readonly name: string;
  /** The bytes of a PNG or JPEG file. */
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export interface ParsedFile {
  /** #P×3, finite, in the file's order. */
  readonly positions: Float64Array<ArrayBuffer>;
  /** Vertices for which `positions` stands in, as the file has no numbers there, see `placeless.ts`. */
  readonly placeless?: readonly number[];
  /** At least one face, each of three corners or more, all indices in range. */
  readonly faces: Faces;
  /** #P×3 linear RGB in [0, 1]. */
  readonly colors?: Float32Array<ArrayBuffer>;
  /** #C×2, v upward; NaN at corners without. Absent where the file has none. */
  readonly uvs?: Float32Array<ArrayBuffer>;
  /** The normal map of all parts, if the file has one inside. */
  readonly normalMap?: EmbeddedImage;
  /** Sentences about what was skipped. */
  readonly warnings: readonly string[];
}

/** A shape on its way into a file of another format. */
export interface Shape {
  readonly positions: Float64Array;
  readonly faces: Faces;
  /** #T×3, the same faces split. */
  readonly triangles: Uint32Array;
  readonly colors?: Float32Array;
  /** #C×2, v upward; NaN at corners without. */
  readonly uvs?: Float32Array;
  /** #T×3: which corner of the faces each of the triangles' is. */
  readonly triangleCorners: Uint32Array;
  readonly look: Look;
}

/** Marks a corner without a stored normal, and other absent indices. */
export const none = 0xffffffff;

/** Faces that are triangles already, #F×3. */
export function triangleFaces(corners: Uint32Array<ArrayBuffer>): Faces {
  const start = new Uint32Array(corners.length / 3 + 1);
  for (let f = 0; f < start.length; f++) start[f] = 3 * f;
  return { start, corners };
}
