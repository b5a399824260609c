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
  /** What the solver takes in place of `triangles` where those repeat each other or disagree about the outside; else absent. */
  readonly solved?: SolvedFaces;
}

/** What is made of a file's faces for the work: each place once, and neighbours looking the same way. */
export interface SolvedFaces {
  /** #S×3 welded vertices. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** #S, the file's face that each is, rising. */
  readonly faceOf: Uint32Array<ArrayBuffer>;
  /** #F, the solved face that each of the file's is or repeats. */
  readonly solvedOf: Uint32Array<ArrayBuffer>;
  /** #S, 1 for those that are turned: corners 1 and 2 have changed places. */
  readonly isTurned: Uint8Array<ArrayBuffer>;
  /** How many faces are left out since they repeat another. */
  readonly repeated: number;
  /** How many are turned. */
  readonly turned: number;
  /** Edges whose two faces cannot look the same way, as on a Möbius strip. */
  readonly oneSidedEdges: number;
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
  /** Vertices of a typical part: of the one in which the middle vertex lies, parts in order of their size. */
  readonly typicalPart: number;
  readonly boundaryEdges: number;
  /** Edges with three faces or more. */
  readonly nonManifoldEdges: number;
  /** Faces of (numerically) zero area, those that use one vertex twice included. */
  readonly degenerateFaces: number;
  /** Faces that repeat the three vertices of an earlier face; they do not count for the work. */
  readonly duplicateFaces: number;
  /** Faces that are turned for the work, so that neighbours look the same way. */
  readonly turnedFaces: number;
  /** Edges whose two faces cannot look the same way, as on a Möbius strip. */
  readonly oneSidedEdges: number;
  /** Vertices that no face uses. They stay where they are, unless they are handles. */
  readonly isolatedVertices: number;
  /** Vertices of parts so far away that they do not count for the unit frame and the view; see `extent.ts`. */
  readonly farVertices: number;
  /** Places that differ from another only by rounding and count as that one. */
  readonly nearPlaces: number;
  /** Axis-aligned box of the positions that faces use, in the file's units. */
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}
