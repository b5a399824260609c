/**
 * A texture as the engine takes it: how the surface is to rise and fall at the corners of its faces. `reliefOf` of
 * `src/inputs/images` makes it of a picture and a mesh.
 */
export interface Relief {
  /** #F×3×2, texture coordinates of the faces' corners, v upward; they say which way u and v go on the surface. */
  readonly uvs: Float32Array;
  /** #F×3×2, rise along u and along v, a number of 1 being 45°. */
  readonly slopes: Float32Array;
}
