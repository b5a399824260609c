/**
 * A style as data: which normal the output is to have where the input has a given one (2021, §3).
 *
 * - `closest`: the nearest of a list of unit normals (#N×3), the faces of a convex shape.
 * - `sphere`: a style mesh flowed to the unit sphere. A normal is looked up as a point of the sphere; the triangle around it
 *   tells the target, interpolated from its corners (`per: 'vertex'`, #V×3) or its own (`per: 'face'`, #F×3, for faceted styles).
 *   Painted spheres and normal captures are of this kind too.
 */
export type GaussMap =
  | { readonly kind: 'closest'; readonly normals: Float64Array }
  | {
      readonly kind: 'sphere';
      /** On the unit sphere, #V×3. */
      readonly points: Float64Array;
      /** Seen from outside counter-clockwise, #F×3. */
      readonly triangles: Uint32Array;
      readonly normals: Float64Array;
      readonly per: 'vertex' | 'face';
    };
