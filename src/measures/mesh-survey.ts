import { ringAreas } from '../mesh/areas.ts';
import { gaussianCurvature, type Rings, ringsOf } from '../mesh/curvature.ts';
import type { Mesh, Weld } from '../mesh/mesh.ts';
import { NormalWriter } from '../mesh/normals.ts';
import { gather, solvedSourceTriangles, solvedTriangles, weldOf } from '../mesh/weld.ts';

const surveys = new WeakMap<Mesh, Survey>();

/** The survey of a mesh, made when first asked for. */
export function surveyOf(mesh: Mesh): Survey {
  let survey = surveys.get(mesh);
  if (!survey) {
    survey = new Survey(mesh);
    surveys.set(mesh, survey);
  }
  return survey;
}

/** What is measured of a mesh whatever the measure: on the welded mesh, so that seams do not show. */
export class Survey {
  readonly vertexOfPosition: Uint32Array;
  readonly #mesh: Mesh;
  readonly #rings: Rings;
  readonly #normals: NormalWriter;
  readonly #weld: Weld;
  /** Values of the file's own shape, which is asked for again and again. */
  readonly #own = new Map<string, Float32Array | Float64Array>();

  constructor(mesh: Mesh) {
    this.#weld = weldOf(mesh);
    const { vertexOfPosition, positionOfVertex } = this.#weld;
    const triangles = solvedTriangles(this.#weld);
    const vertices = positionOfVertex.length;
    this.#mesh = mesh;
    this.vertexOfPosition = vertexOfPosition;
    this.#rings = ringsOf(triangles, vertices);
    this.#normals = new NormalWriter(solvedSourceTriangles(mesh), triangles, vertexOfPosition, vertices);
  }

  /** Unit normals, #P×3, of positions (#P×3). */
  normals(positions: Float64Array): Float32Array {
    return this.#remembered('normals', positions, () => {
      const normals = new Float32Array(positions.length);
      // Single precision needs the origin near.
      const near = new Float32Array(positions.length);
      for (let i = 0; i < near.length; i++) near[i] = positions[i]! - positions[i % 3]!;
      this.#normals.write(near, normals);
      return normals;
    });
  }

  /** Gaussian curvature, #V, see {@link gaussianCurvature}. */
  curvature(positions: Float64Array): Float64Array {
    return this.#remembered('curvature', positions, () =>
      gaussianCurvature(gather(positions, this.#weld), this.#rings),
    );
  }

  /** The diagonal of the file's own box: what lengths are told in. */
  get diagonal(): number {
    const { positions } = this.#mesh;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < positions.length; i++) {
      low[i % 3] = Math.min(low[i % 3]!, positions[i]!);
      high[i % 3] = Math.max(high[i % 3]!, positions[i]!);
    }
    return Math.hypot(...high.map((top, axis) => top - low[axis]!));
  }

  /** Area of the file's own shape. */
  get area(): number {
    return this.ringAreas(this.#mesh.positions).reduce((sum, area) => sum + area, 0) / 3;
  }

  /** Area of the faces around each vertex, #V. */
  ringAreas(positions: Float64Array): Float64Array {
    return this.#remembered('areas', positions, () =>
      ringAreas(gather(positions, this.#weld), solvedTriangles(this.#weld)),
    );
  }

  /** Values of vertices (#V) for positions, #P. */
  spread(values: Float64Array): Float32Array<ArrayBuffer> {
    const spread = new Float32Array(this.vertexOfPosition.length);
    for (let p = 0; p < spread.length; p++) spread[p] = values[this.vertexOfPosition[p]!]!;
    return spread;
  }

  #remembered<T extends Float32Array | Float64Array>(
    what: string,
    positions: Float64Array,
    measure: () => T,
  ): T {
    if (positions !== this.#mesh.positions) return measure();
    const values = (this.#own.get(what) as T | undefined) ?? measure();
    this.#own.set(what, values);
    return values;
  }
}
