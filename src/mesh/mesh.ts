/**
 * A triangle mesh as its file describes it: positions in the file's own order, units and place. Polygons are split into
 * triangles; vertices that a file stores several times (seams, STL corners) stay apart here, see {@link Weld}.
 */
export interface Mesh {
  /** #P×3, xyz interleaved, in the file's position order. */
  readonly positions: Float64Array<ArrayBuffer>;
  /** #F×3 indices into `positions`. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** Which positions are one place; absent where nobody asked yet, see `weldOf`. */
  readonly weld?: Weld;
  /** #P×3 linear RGB in [0, 1], if the file colours its vertices. */
  readonly colors?: Float32Array<ArrayBuffer>;
  /**
   * #F×3×2, texture coordinates of every face corner, if the file has them: u to the right, v upward, so that the top row of a
   * image is at v = 1 whatever the format says. NaN at corners that have none.
   */
  readonly uvs?: Float32Array<ArrayBuffer>;
}

/**
 * Which positions of a mesh are one vertex for the solver: those that its file has in one place, but for rounding. A weld is made once a file and
 * carried on by every mesh that steps make of it, so that two vertices that a step brought together stay two.
 */
export interface Weld {
  /** #P: the welded vertex of each source position. */
  readonly vertexOfPosition: Uint32Array<ArrayBuffer>;
  /** #V: the first source position of each welded vertex, rising. */
  readonly positionOfVertex: Uint32Array<ArrayBuffer>;
  /** #F×3 indices of welded vertices, same faces in the same order as the source. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** What was joined though it differs by rounding; absent where nothing was. */
  readonly near?: NearPlaces;
}

/** Source positions that are not where the first position of their vertex is, but nearly. */
export interface NearPlaces {
  /** How many places were joined to others. */
  readonly places: number;
  /** #N source positions, rising. */
  readonly positions: Uint32Array<ArrayBuffer>;
  /** #N×3, how far each lies from the first position of its vertex. */
  readonly offsets: Float64Array<ArrayBuffer>;
}

/** What the core says of a mesh once it has looked at it. Counts are those of the welded mesh, faces as given. */
export interface MeshReport {
  readonly vertices: number;
  readonly faces: number;
  /** Connected parts that have at least one face. */
  readonly components: number;
  readonly boundaryEdges: number;
  /** Edges with three faces or more. */
  readonly nonManifoldEdges: number;
  /** Faces of (numerically) zero area, those that use one vertex twice included. */
  readonly degenerateFaces: number;
  /** Faces that repeat the three vertices of an earlier face. */
  readonly duplicateFaces: number;
  /** Vertices that no face uses. They stay where they are. */
  readonly isolatedVertices: number;
  /** Places that differ from another only by rounding and count as that one. */
  readonly nearPlaces: number;
  /** Axis-aligned box of all positions, in the file's units. */
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}
