import { Matrix4 } from 'three';
import type { ScreenPoint, ScreenShape } from '../../src/selection/index.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';

/** Where the drawn vertices of a mesh are on the canvas, from where one looks at it now. */
export class ScreenMap {
  /** File units that a pixel is wide at a distance of one. */
  readonly #unitsOfPixel: number;
  readonly #focal: number;
  readonly #matrix: readonly number[];
  readonly #drawn: ArrayLike<number>;
  readonly #positionOfVertex: ArrayLike<number>;
  readonly #width: number;
  readonly #height: number;

  /** @param positionOfVertex #V, the first source position of each welded vertex */
  constructor(viewer: Viewer, positionOfVertex: ArrayLike<number>) {
    const { camera, overlay, surface } = viewer.space;
    this.#width = viewer.canvas.clientWidth;
    this.#height = viewer.canvas.clientHeight;
    overlay.updateWorldMatrix(true, false);
    camera.updateMatrixWorld();
    const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.#matrix = matrix.multiply(overlay.matrixWorld).elements;
    this.#focal = (camera.projectionMatrix.elements[5]! * this.#height) / 2;
    this.#unitsOfPixel = 1 / (this.#focal * surface!.frame.scale);
    this.#drawn = surface!.drawn;
    this.#positionOfVertex = positionOfVertex;
  }

  /** Of a welded vertex; NaN for one behind the camera. */
  readonly place = (vertex: number): ScreenPoint => {
    const w = this.#along(vertex, 3);
    if (!(w > 0)) return [Number.NaN, Number.NaN];
    return [
      ((this.#along(vertex, 0) / w + 1) * this.#width) / 2,
      ((1 - this.#along(vertex, 1) / w) * this.#height) / 2,
    ];
  };

  /** File units in so many pixels at the depth of a vertex. */
  unitsAt(vertex: number, pixels: number): number {
    return pixels * this.#along(vertex, 3) * this.#unitsOfPixel;
  }

  /** Whether another map has everything in the same place, if the shape is the same. */
  isLike(other: ScreenMap): boolean {
    return (
      this.#drawn === other.#drawn &&
      this.#width === other.#width &&
      this.#height === other.#height &&
      this.#matrix.every((value, k) => value === other.#matrix[k])
    );
  }

  /** All of it at once. */
  shape(): ScreenShape {
    const count = this.#positionOfVertex.length;
    const places = new Float32Array(2 * count);
    const depths = new Float32Array(count);
    for (let v = 0; v < count; v++) {
      const w = this.#along(v, 3);
      depths[v] = w;
      places[2 * v] = w > 0 ? ((this.#along(v, 0) / w + 1) * this.#width) / 2 : Number.NaN;
      places[2 * v + 1] = w > 0 ? ((1 - this.#along(v, 1) / w) * this.#height) / 2 : Number.NaN;
    }
    return { places, depths, focal: this.#focal, width: this.#width, height: this.#height };
  }

  /** A row of clip space: x, y, z, w are 0 to 3. */
  #along(vertex: number, row: number): number {
    const m = this.#matrix;
    const p = 3 * this.#positionOfVertex[vertex]!;
    const x = this.#drawn;
    return m[row]! * x[p]! + m[row + 4]! * x[p + 1]! + m[row + 8]! * x[p + 2]! + m[row + 12]!;
  }
}
