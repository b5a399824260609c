import { BufferAttribute, BufferGeometry, DynamicDrawUsage, type Matrix4, Vector3 } from 'three';
import { edgesOf } from '../mesh/edges.ts';
import { type Extent, extentOf } from '../mesh/extent.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { NormalWriter } from '../mesh/normals.ts';
import { solvedSourceTriangles, solvedTriangles, weldOf } from '../mesh/weld.ts';
import { frameOf, toView, type ViewFrame } from './view-frame.ts';

/**
 * The drawn geometry of one mesh. GPU vertices are the file's positions in the file's order, so an update is one straight
 * copy into the buffers that are already there; nothing is allocated while a solve runs.
 */
export class Surface {
  readonly geometry = new BufferGeometry();
  readonly frame: ViewFrame;
  /** Of the file's own shape, along the axes, in view units. */
  readonly size: readonly [x: number, y: number, z: number];
  readonly #mesh: Mesh;
  /** #S×3: each place once, and looking the same way, or light would fall on both sides of it. */
  readonly #triangles: Uint32Array<ArrayBuffer>;
  /** Positions to look at, rising: none far from all that matters, and none that is no number. */
  readonly #shown: Uint32Array;
  readonly #welded: { triangles: Uint32Array; vertices: number };
  readonly #normals: NormalWriter;
  readonly #position: BufferAttribute;
  readonly #normal: BufferAttribute;
  #edges: BufferGeometry | null = null;

  constructor(mesh: Mesh) {
    this.#mesh = mesh;
    const extent = extentOf(mesh.positions, mesh.triangles);
    this.frame = frameOf(extent);
    this.#shown = insideOf(extent, mesh.positions);
    const sideOf = (axis: 0 | 1 | 2): number => (extent.max[axis] - extent.min[axis]) * this.frame.scale;
    this.size = [sideOf(0), sideOf(1), sideOf(2)];
    const { vertexOfPosition, positionOfVertex } = weldOf(mesh);
    const vertices = positionOfVertex.length;
    const triangles = solvedTriangles(weldOf(mesh));
    this.#triangles = solvedSourceTriangles(mesh);
    this.#welded = { triangles, vertices };
    this.#normals = new NormalWriter(this.#triangles, triangles, vertexOfPosition, vertices);
    this.#position = dynamic(mesh.positions.length);
    this.#normal = dynamic(mesh.positions.length);
    this.geometry.setAttribute('position', this.#position);
    this.geometry.setAttribute('normal', this.#normal);
    this.geometry.setIndex(new BufferAttribute(this.#triangles, 1));
    this.paint(null);
    this.write(mesh.positions);
  }

  get hasColors(): boolean {
    return this.geometry.hasAttribute('color');
  }

  /** Colours of your own (#P×3, linear), or null for the file's. */
  paint(colors: Float32Array<ArrayBuffer> | null): void {
    const shown = colors ?? this.#mesh.colors;
    if (shown) this.geometry.setAttribute('color', new BufferAttribute(shown, 3));
    else this.geometry.deleteAttribute('color');
  }

  /** Sends colours to the GPU that were written into the array last given to {@link paint}. @param touched positions whose colour changed */
  touchColors(touched: ArrayLike<number>): void {
    const colors = this.geometry.getAttribute('color') as BufferAttribute | undefined;
    if (!colors || touched.length === 0) return;
    let [low, high] = [touched[0]!, touched[0]!];
    for (let k = 1; k < touched.length; k++) {
      low = Math.min(low, touched[k]!);
      high = Math.max(high, touched[k]!);
    }
    colors.addUpdateRange(3 * low, 3 * (high - low + 1));
    colors.needsUpdate = true;
  }

  /** The drawn faces by positions of the file, #S×3: each place once, and looking the same way. */
  get triangles(): Uint32Array<ArrayBuffer> {
    return this.#triangles;
  }

  get mesh(): Mesh {
    return this.#mesh;
  }

  /** View-space positions as they are drawn now, #P×3; a live view, not a copy. */
  get drawn(): Float32Array {
    return this.#position.array as Float32Array;
  }

  /** Draws positions of the file (#P×3) from now on. */
  write(positions: Float64Array): void {
    toView(positions, this.frame, this.drawn);
    this.touch();
  }

  /** To be called after {@link drawn} was written to: renews normals and tells the GPU. */
  touch(): void {
    this.#normals.write(this.drawn, this.#normal.array as Float32Array);
    this.#position.needsUpdate = true;
    this.#normal.needsUpdate = true;
  }

  /** The edges as line segments over the same position buffer; made when first asked for. */
  edges(): BufferGeometry {
    if (this.#edges) return this.#edges;
    const edges = new BufferGeometry();
    edges.setAttribute('position', this.#position);
    const { ends } = edgesOf(this.#welded.triangles, this.#triangles, this.#welded.vertices);
    edges.setIndex(new BufferAttribute(ends, 1));
    this.#edges = edges;
    return edges;
  }

  /** Where the faces look. An open surface counts by the body it is most of; a sheet encloses nothing and has no inside. */
  get facing(): 'out' | 'in' | 'neither' {
    const x = this.drawn;
    const corners = this.#triangles;
    let sixfoldVolume = 0;
    let doubledArea = 0;
    for (let c = 0; c < corners.length; c += 3) {
      const [a, b, d] = [3 * corners[c]!, 3 * corners[c + 1]!, 3 * corners[c + 2]!];
      const [ux, uy, uz] = [x[b]! - x[a]!, x[b + 1]! - x[a + 1]!, x[b + 2]! - x[a + 2]!];
      const [vx, vy, vz] = [x[d]! - x[a]!, x[d + 1]! - x[a + 1]!, x[d + 2]! - x[a + 2]!];
      const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      sixfoldVolume += x[a]! * nx + x[a + 1]! * ny + x[a + 2]! * nz;
      doubledArea += Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
    // 36π V² / A³ is 1 for a ball and less for all else.
    const isSheet = Math.PI * sixfoldVolume ** 2 < flatBody * (doubledArea / 2) ** 3;
    return isSheet ? 'neither' : sixfoldVolume > 0 ? 'out' : 'in';
  }

  /** Smallest drawn coordinate on an axis (0, 1, 2): where the ground goes. */
  lowest(axis: 0 | 1 | 2): number {
    const x = this.drawn;
    let low = Infinity;
    for (const p of this.#shown) if (x[3 * p + axis]! < low) low = x[3 * p + axis]!;
    return Number.isFinite(low) ? low : 0;
  }

  /** How far from the middle of the frame the farthest of what is shown is. */
  get reach(): number {
    const x = this.drawn;
    let square = 0;
    for (const p of this.#shown)
      square = Math.max(square, x[3 * p]! ** 2 + x[3 * p + 1]! ** 2 + x[3 * p + 2]! ** 2);
    return Math.sqrt(square);
  }

  /** Some of what is shown, where it is drawn. @param toWorld from the file's axes in view units */
  *samples(toWorld: Matrix4): Generator<Vector3> {
    const step = Math.max(1, Math.floor(this.#shown.length / mostSamples));
    for (let k = 0; k < this.#shown.length; k += step)
      yield new Vector3().fromArray(this.drawn, 3 * this.#shown[k]!).applyMatrix4(toWorld);
  }

  dispose(): void {
    this.geometry.dispose();
    this.#edges?.dispose();
  }
}

/** The positions in a box. */
function insideOf({ min, max }: Extent, positions: Float64Array): Uint32Array {
  const inside = new Uint32Array(positions.length / 3);
  let count = 0;
  for (let p = 0; p < inside.length; p++) {
    const [x, y, z] = [positions[3 * p]!, positions[3 * p + 1]!, positions[3 * p + 2]!];
    const isInside = x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1] && z >= min[2] && z <= max[2];
    if (isInside) inside[count++] = p;
  }
  return inside.subarray(0, count);
}

/** Enough to know whether a shape is in view, but for a tip. */
const mostSamples = 2000;

/** Bodies flatter than this, by volume for their area, are sheets. */
const flatBody = 0.02;

function dynamic(length: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(length), 3).setUsage(DynamicDrawUsage);
}
