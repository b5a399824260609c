import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Vec3 } from '../../src/mesh/vectors.ts';
import { gather, solvedTriangles, weldOf } from '../../src/mesh/weld.ts';
import type { SphereField } from '../../src/methods/values/sphere-field.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import { strengthColor } from '../app/color-ramp.ts';

/** How a rest shape looks, for showing a field by direction on it. */
interface RestLook {
  /** #S×3, unit. */
  readonly faceNormals: Float32Array;
  /** #V×3, unit or zero. */
  readonly vertexNormals: Float32Array;
}

/** What colours are made of. */
export interface ShownStrength {
  readonly mesh: Mesh;
  /** #P×3, the shape that the step begins from: its normals count. */
  readonly rest: Float64Array;
  /** #V; null is all of it. */
  readonly shares: Float64Array | null;
  /** Null is all of it. */
  readonly field: SphereField | null;
}

/** Shows how strong the style is as colours of the mesh; what a brush has touched is recoloured alone. */
export class StrengthView {
  readonly #viewer: Viewer;
  #shown: ShownStrength | null = null;
  #colors = new Float32Array();
  #look: RestLook | null = null;
  /** The pixel of the field that each vertex looks to, #V; null without a field. */
  #pixels: Uint32Array | null = null;
  #positions: PositionsOfVertices | null = null;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
  }

  /** Colours everything, if anything has changed. */
  show(next: ShownStrength): void {
    const last = this.#shown;
    const isSame = (name: keyof ShownStrength) => last?.[name] === next[name];
    if (isSame('mesh') && isSame('rest') && isSame('shares') && isSame('field')) return;
    if (!isSame('mesh')) this.#positions = new PositionsOfVertices(weldOf(next.mesh).vertexOfPosition);
    if (!isSame('mesh') || !isSame('rest')) this.#look = null;
    if (!this.#look || last?.field?.height !== next.field?.height) this.#pixels = null;
    this.#shown = next;
    const isNew = !isSame('mesh') || this.#colors.length !== next.mesh.positions.length;
    if (isNew) this.#colors = new Float32Array(next.mesh.positions.length);
    const pixels = this.#pixelsOf(next.field);
    for (let vertex = 0; vertex < this.#positions!.count; vertex++) this.#paint(vertex, pixels);
    this.#viewer.setColors(this.#colors);
  }

  /** Colours some vertices anew, whose shares were written into the array that is shown. */
  touch(vertices: readonly number[], shares: Float64Array): void {
    if (!this.#shown) return;
    this.#shown = { ...this.#shown, shares };
    const pixels = this.#pixelsOf(this.#shown.field);
    for (const vertex of vertices) this.#paint(vertex, pixels);
    this.#viewer.touchColors(this.#positions!.of(vertices));
  }

  get isShown(): boolean {
    return this.#shown !== null;
  }

  /** Colours everything anew when it is asked for next: somebody else has coloured the mesh. */
  forget(): void {
    this.#shown = null;
  }

  /** Takes the colours away. */
  hide(): void {
    if (this.#shown) this.#viewer.setColors(null);
    this.#shown = null;
  }

  /** Where a face of the rest shape looks, unit. */
  normalOf(face: number): Vec3 {
    const { faceNormals } = this.#restLook();
    return [faceNormals[3 * face]!, faceNormals[3 * face + 1]!, faceNormals[3 * face + 2]!];
  }

  /** The drawn faces of the rest shape that look within an angle of a direction, by three positions each. */
  facesTowards([x, y, z]: Vec3, angle: number, drawn: Uint32Array): Uint32Array {
    const { faceNormals } = this.#restLook();
    const least = Math.cos(angle);
    const corners = new Uint32Array(drawn.length);
    let count = 0;
    for (let corner = 0; corner < drawn.length; corner += 3) {
      const cosine = x * faceNormals[corner]! + y * faceNormals[corner + 1]! + z * faceNormals[corner + 2]!;
      if (cosine < least) continue;
      corners[count++] = drawn[corner]!;
      corners[count++] = drawn[corner + 1]!;
      corners[count++] = drawn[corner + 2]!;
    }
    return corners.slice(0, count);
  }

  #paint(vertex: number, pixels: Uint32Array | null): void {
    const { shares, field } = this.#shown!;
    const share = (shares?.[vertex] ?? 1) * (pixels ? field!.values[pixels[vertex]!]! : 1);
    const color = strengthColor(share);
    const { start, positions } = this.#positions!;
    for (let i = start[vertex]!; i < start[vertex + 1]!; i++) {
      const at = 3 * positions[i]!;
      this.#colors[at] = color[0];
      this.#colors[at + 1] = color[1];
      this.#colors[at + 2] = color[2];
    }
  }

  #restLook(): RestLook {
    const { mesh, rest } = this.#shown!;
    this.#look ??= restLookOf(mesh, rest);
    return this.#look;
  }

  #pixelsOf(field: SphereField | null): Uint32Array | null {
    if (!field || this.#pixels) return field && this.#pixels;
    const { vertexNormals } = this.#restLook();
    const { width, height } = field;
    this.#pixels = Uint32Array.from({ length: vertexNormals.length / 3 }, (_, v) => {
      const [x, y, z] = [vertexNormals[3 * v]!, vertexNormals[3 * v + 1]!, vertexNormals[3 * v + 2]!];
      const column = Math.floor((Math.atan2(x, z) / (2 * Math.PI) + 0.5) * width);
      const row = Math.floor((Math.acos(Math.max(-1, Math.min(1, y))) / Math.PI) * height);
      return Math.min(height - 1, row) * width + Math.min(width - 1, column);
    });
    return this.#pixels;
  }
}

/** The positions of the file that each welded vertex has. */
class PositionsOfVertices {
  readonly start: Uint32Array;
  readonly positions: Uint32Array;

  constructor(vertexOfPosition: Uint32Array) {
    const vertices = vertexOfPosition.reduce((most, vertex) => Math.max(most, vertex + 1), 0);
    this.start = new Uint32Array(vertices + 1);
    for (const vertex of vertexOfPosition) this.start[vertex + 1]!++;
    for (let v = 0; v < vertices; v++) this.start[v + 1]! += this.start[v]!;
    this.positions = new Uint32Array(vertexOfPosition.length);
    const next = this.start.slice(0, vertices);
    vertexOfPosition.forEach((vertex, position) => {
      this.positions[next[vertex]!++] = position;
    });
  }

  get count(): number {
    return this.start.length - 1;
  }

  of(vertices: readonly number[]): readonly number[] {
    const all: number[] = [];
    for (const vertex of vertices)
      for (let i = this.start[vertex]!; i < this.start[vertex + 1]!; i++) all.push(this.positions[i]!);
    return all;
  }
}

function restLookOf(mesh: Mesh, rest: Float64Array): RestLook {
  const weld = weldOf(mesh);
  const x = gather(rest, weld);
  const triangles = solvedTriangles(weld);
  const faceNormals = new Float32Array(triangles.length);
  const vertexNormals = new Float32Array(x.length);
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = [3 * triangles[corner]!, 3 * triangles[corner + 1]!, 3 * triangles[corner + 2]!];
    const [ux, uy, uz] = [x[b]! - x[a]!, x[b + 1]! - x[a + 1]!, x[b + 2]! - x[a + 2]!];
    const [vx, vy, vz] = [x[c]! - x[a]!, x[c + 1]! - x[a + 1]!, x[c + 2]! - x[a + 2]!];
    faceNormals[corner] = uy * vz - uz * vy;
    faceNormals[corner + 1] = uz * vx - ux * vz;
    faceNormals[corner + 2] = ux * vy - uy * vx;
    for (let k = 0; k < 3; k++) {
      vertexNormals[a + k]! += faceNormals[corner + k]!;
      vertexNormals[b + k]! += faceNormals[corner + k]!;
      vertexNormals[c + k]! += faceNormals[corner + k]!;
    }
  }
  toUnit(faceNormals);
  toUnit(vertexNormals);
  return { faceNormals, vertexNormals };
}

/** Makes vectors (#×3) as long as 1, but for those of length 0. */
function toUnit(vectors: Float32Array): void {
  for (let at = 0; at < vectors.length; at += 3) {
    const length = Math.sqrt(vectors[at]! ** 2 + vectors[at + 1]! ** 2 + vectors[at + 2]! ** 2) || 1;
    for (let k = 0; k < 3; k++) vectors[at + k]! /= length;
  }
}
