import type { FilesBeside } from '../beside.ts';
import { FloatList, IndexList } from '../lists.ts';
import { none, type ParsedFile, triangleFaces } from '../parsed-file.ts';
import { settlePlaceless } from '../placeless.ts';
import { counted, refusal } from '../refuse.ts';
import { Accessor } from './accessor.ts';
import { type Elsewhere, GltfDocument, type Json } from './document.ts';
import { imageInside } from './images.ts';
import {
  apply3,
  applyTransposed3,
  invert3,
  isMirrored,
  linearPart,
  type Matrix,
  sameMatrix,
} from './matrix.ts';
import { NormalMapSearch } from './normal-map.ts';
import { type Placement, placements } from './scene.ts';

/** One accessor of positions, normals or tangents, and which elements of the whole it holds. */
export interface GltfPart {
  readonly accessor: Accessor;
  /** Index of its first element among all positions, or among all normals. */
  readonly first: number;
  readonly toWorld: Matrix;
}

export interface GltfNormals extends GltfPart {
  readonly tangents?: Accessor;
}

/** A glTF asset as one mesh in the frame of its scene, and where its numbers came from. */
export interface GltfFile extends ParsedFile {
  readonly document: GltfDocument;
  readonly parts: readonly GltfPart[];
  readonly normalParts: readonly GltfNormals[];
  /** #N×3 in the frame of the scene. */
  readonly normals: Float64Array;
  /** #C index of the normal of each corner, or {@link none}. */
  readonly normalOfCorner: Uint32Array;
  /** Which faces came from which primitive. */
  readonly primitives: readonly GltfPrimitive[];
}

export interface GltfPrimitive {
  readonly firstFace: number;
  readonly name: string;
  /** As the file has it. */
  readonly material: unknown;
}

/**
 * Reads glTF 2 and GLB. Positions are those of the default scene, node transforms applied; where a transform mirrors, triangles
 * are read the other way round, so that they look outwards. A mesh that stands in the
 * scene several times is taken once, at its first place: it has one set of positions in the file, so its other places
 * follow when it is edited.
 *
 * @throws no-faces, index-out-of-range, malformed-file, truncated-file, not-finite, unsupported-file, too-large
 */
export function scanGltf(bytes: Uint8Array, name: string, isBinary: boolean, beside?: FilesBeside): GltfFile {
  return new GltfScan(new GltfDocument(bytes, name, isBinary, beside)).run();
}

const wholeNumbers =
  'Its positions are stored as whole numbers; in the result they are decimal ones, in a part of their own.';

class GltfScan {
  readonly #document: GltfDocument;
  readonly #positions = new FloatList();
  readonly #colors = new FloatList();
  readonly #normals = new FloatList();
  readonly #corners = new IndexList();
  readonly #normalOfCorner = new IndexList();
  /** By accessor. */
  readonly #parts = new Map<unknown, GltfPart>();
  readonly #normalParts = new Map<unknown, GltfNormals>();
  readonly #meshes = new Set<number>();
  readonly #warnings = new Set<string>();
  readonly #primitives: GltfPrimitive[] = [];
  readonly #normalMap: NormalMapSearch;
  /** Texture coordinates of every corner, v upward; empty as long as no part has any. */
  readonly #uvs = new FloatList();
  #skippedPrimitives = 0;
  #repeated = 0;

  constructor(document: GltfDocument) {
    this.#document = document;
    this.#normalMap = new NormalMapSearch(document);
  }

  run(): GltfFile {
    for (const placement of placements(this.#document)) {
      if (this.#meshes.has(placement.mesh)) this.#repeated++;
      else this.#mesh(placement);
    }
    const corners = this.#corners.take();
    if (corners.length === 0) {
      const sentence = 'the scene has no triangles; export it as a mesh with faces.';
      throw refusal('no-faces', this.#document.name, '', sentence);
    }
    const positions = this.#positions.take();
    const { placeless, warnings } = settlePlaceless(positions, corners, (p) => this.#notFinite(p, positions));
    const colors = this.#colors.length > 0 ? { colors: this.#finishColors(positions.length) } : {};
    const normalMap = this.#normalMap.found();
    return {
      document: this.#document,
      positions,
      ...(placeless ? { placeless } : {}),
      faces: triangleFaces(corners),
      ...colors,
      ...this.#finishUvs(corners.length),
      ...(normalMap ? { normalMap } : {}),
      warnings: [...this.#finishWarnings(), ...warnings],
      parts: [...this.#parts.values()],
      normalParts: [...this.#normalParts.values()],
      normals: this.#normals.take(),
      normalOfCorner: this.#normalOfCorner.take(),
      primitives: this.#primitives,
    };
  }

  #mesh(placement: Placement): void {
    const document = this.#document;
    this.#meshes.add(placement.mesh);
    if (placement.isSkinned) this.#warnings.add('The mesh has a skeleton; its rest shape is used.');
    const place = `mesh ${placement.mesh}`;
    const primitives = document.list(
      document.element('meshes', placement.mesh, placement.place),
      'primitives',
    );
    primitives.forEach((primitive, i) => {
      const where = `${place}, primitive ${i}`;
      this.#primitive(document.record(primitive, where), placement, where);
    });
  }

  #primitive(json: Json, { toWorld, name }: Placement, place: string): void {
    const document = this.#document;
    this.#refuseCompression(json, place);
    const mode = document.count(json.mode, place, 4);
    const attributes = document.record(json.attributes ?? {}, place);
    if (mode < 4 || attributes.POSITION === undefined) {
      this.#skippedPrimitives++;
      return;
    }
    if (mode > 6) throw document.malformed(place, `its mode ${mode} does not exist`);
    if (document.list(json, 'targets').length > 0) {
      this.#warnings.add(
        'The mesh has morph targets; its rest shape is used, and the targets are not reshaped.',
      );
    }
    const part = this.#part(attributes, toWorld, place);
    if (!part) {
      this.#repeated++;
      return;
    }
    const normals = this.#normalPart(attributes, part, place);
    const vertices = part.accessor.count;
    const indices = this.#indices(json, vertices, place);
    const triangleCount = mode === 4 ? Math.floor(indices.length / 3) : Math.max(0, indices.length - 2);
    document.spend(triangleCount, place);
    const uvs = this.#uvValues(attributes, vertices, place);
    if (uvs) this.#normalMap.add(json.material);
    const corner = (i: number) => {
      if (uvs) this.#addUv(uvs, indices[i]);
      this.#corners.push(part.first + indices[i]);
      this.#normalOfCorner.push(normals ? normals.first + indices[i] : none);
    };
    this.#primitives.push({ firstFace: this.#corners.length / 3, name, material: json.material });
    const isTurned = isMirrored(toWorld);
    for (let t = 0; t < triangleCount; t++) {
      const turned = mode === 5 ? t & 1 : 0;
      const second = mode === 4 ? 3 * t + 1 : mode === 5 ? t + 1 - turned : t + 1;
      const third = mode === 4 ? 3 * t + 2 : t + 2;
      corner(mode === 4 ? 3 * t : mode === 5 ? t + turned : 0);
      corner(isTurned ? third : second);
      corner(isTurned ? second : third);
    }
  }

  #refuseCompression(json: Json, place: string): void {
    const extensions = this.#document.record(json.extensions ?? {}, place);
    if (extensions.KHR_draco_mesh_compression === undefined) return;
    const sentence = 'it is compressed with Draco; open it with an engine, which loads the decoder.';
    throw refusal('unsupported-file', this.#document.name, place, sentence);
  }

  /** The positions of a primitive; undefined if they are in the mesh already, at another place. */
  #part(attributes: Json, toWorld: Matrix, place: string): GltfPart | undefined {
    const known = this.#parts.get(attributes.POSITION);
    if (known) return sameMatrix(known.toWorld, toWorld) ? known : undefined;
    const document = this.#document;
    const accessor = new Accessor(document, attributes.POSITION, place);
    if (accessor.components !== 3)
      throw document.malformed(`accessor ${accessor.index}`, 'positions are not VEC3');
    if (!accessor.isFloat) this.#warnings.add(wholeNumbers);
    const part = { accessor, first: this.#positions.length / 3, toWorld };
    this.#parts.set(attributes.POSITION, part);
    this.#addPositions(part);
    if (attributes.COLOR_0 !== undefined) this.#addColors(attributes.COLOR_0, part, place);
    return part;
  }

  #addPositions({ accessor, toWorld }: GltfPart): void {
    const local = accessor.read();
    const linear = linearPart(toWorld);
    const world = new Float64Array(3);
    for (let i = 0; i < local.length; i += 3) {
      apply3(linear, local[i], local[i + 1], local[i + 2], world, 0);
      for (let axis = 0; axis < 3; axis++) {
        world[axis] += toWorld[12 + axis];
      }
      this.#positions.push3(world[0], world[1], world[2]);
    }
  }

  #notFinite(p: number, positions: Float64Array): Error {
    const { accessor, first } = [...this.#parts.values()].findLast((part) => part.first <= p)!;
    const value = positions.subarray(3 * p, 3 * p + 3).find((x) => !Number.isFinite(x));
    const sentence = `vertex ${p - first} ends up at the coordinate ${value}; repair the mesh and export it again.`;
    return refusal('not-finite', this.#document.name, `accessor ${accessor.index}`, sentence, p - first);
  }

  /** Texture coordinates of the primitive's vertices, #V×2, v downward as glTF has it. */
  #uvValues(attributes: Json, vertices: number, place: string): Float64Array | undefined {
    if (attributes.TEXCOORD_0 === undefined) return undefined;
    const accessor = new Accessor(this.#document, attributes.TEXCOORD_0, place);
    if (accessor.components === 2 && accessor.count >= vertices) return accessor.read();
    this.#warnings.add(`The texture coordinates of ${place} do not fit its positions; they are left out.`);
    return undefined;
  }

  #addUv(values: Float64Array, vertex: number): void {
    while (this.#uvs.length < 2 * this.#corners.length) this.#uvs.push(Number.NaN);
    this.#uvs.push2(values[2 * vertex], 1 - values[2 * vertex + 1]);
  }

  #finishUvs(corners: number): { uvs?: Float32Array<ArrayBuffer> } {
    if (this.#uvs.length === 0) return {};
    while (this.#uvs.length < 2 * corners) this.#uvs.push(Number.NaN);
    return { uvs: Float32Array.from(this.#uvs.take()) };
  }

  #addColors(index: unknown, part: GltfPart, place: string): void {
    const accessor = new Accessor(this.#document, index, place);
    const values = accessor.read();
    const step = accessor.components;
    if (step < 3) return;
    while (this.#colors.length < 3 * part.first) this.#colors.push(1);
    for (let v = 0; v < Math.min(accessor.count, part.accessor.count); v++) {
      this.#colors.push3(values[v * step], values[v * step + 1], values[v * step + 2]);
    }
  }

  #finishColors(length: number): Float32Array<ArrayBuffer> {
    while (this.#colors.length < length) this.#colors.push(1);
    return Float32Array.from(this.#colors.take(), (c) => (Number.isNaN(c) ? 1 : Math.min(1, Math.max(0, c))));
  }

  #normalPart(attributes: Json, part: GltfPart, place: string): GltfNormals | undefined {
    if (attributes.NORMAL === undefined) return undefined;
    const known = this.#normalParts.get(attributes.NORMAL);
    if (known) return known.accessor.count >= part.accessor.count ? known : undefined;
    const accessor = new Accessor(this.#document, attributes.NORMAL, place);
    if (accessor.components !== 3 || accessor.count < part.accessor.count) {
      this.#warnings.add(`The normals of ${place} do not fit its positions; they are left as they are.`);
      return undefined;
    }
    const tangents = this.#tangents(attributes, accessor, place);
    const first = this.#normals.length / 3;
    const result = { accessor, first, toWorld: part.toWorld, ...(tangents ? { tangents } : {}) };
    this.#normalParts.set(attributes.NORMAL, result);
    const local = accessor.read();
    const inverse = invert3(linearPart(part.toWorld)) ?? linearPart(part.toWorld);
    const world = new Float64Array(3);
    for (let i = 0; i < local.length; i += 3) {
      applyTransposed3(inverse, local[i], local[i + 1], local[i + 2], world, 0);
      this.#normals.push3(world[0], world[1], world[2]);
    }
    return result;
  }

  #tangents(attributes: Json, normals: Accessor, place: string): Accessor | undefined {
    if (attributes.TANGENT === undefined) return undefined;
    const tangents = new Accessor(this.#document, attributes.TANGENT, place);
    return tangents.components === 4 && tangents.count >= normals.count ? tangents : undefined;
  }

  #indices(json: Json, vertices: number, place: string): Uint32Array {
    if (json.indices === undefined) {
      this.#document.spend(vertices, place);
      return new Uint32Array(vertices).map((_, i) => i);
    }
    const accessor = new Accessor(this.#document, json.indices, place);
    if (accessor.components !== 1 || accessor.isFloat) {
      throw this.#document.malformed(`accessor ${accessor.index}`, 'indices are not whole numbers');
    }
    const indices = new Uint32Array(accessor.read());
    const bad = indices.findIndex((index) => index >= vertices);
    if (bad < 0) return indices;
    const sentence = `it uses vertex ${indices[bad]}, but there are only ${vertices}; export the file again.`;
    throw refusal('index-out-of-range', this.#document.name, `accessor ${accessor.index}`, sentence, bad);
  }

  /** What becomes of files beside this one. */
  #elsewhere(): string[] {
    const document = this.#document;
    const files = document.elsewhere();
    const isInside = ({ key, path }: Elsewhere) =>
      key === 'buffers' || imageInside(document, path) !== undefined;
    const list = (found: readonly Elsewhere[]) => [...new Set(found.map(({ path }) => path))].join(', ');
    const inside = list(files.filter(isInside));
    const outside = list(files.filter((file) => !isInside(file)));
    return [
      ...(inside ? [`Its data lies beside it (${inside}); the result has it inside.`] : []),
      ...(outside ? [`The result looks for the same images beside it: ${outside}.`] : []),
    ];
  }

  #finishWarnings(): string[] {
    const warnings = [...this.#warnings];
    if (this.#skippedPrimitives > 0) {
      warnings.push(`Left out ${counted(this.#skippedPrimitives, 'part')} made of points or lines.`);
    }
    warnings.push(...this.#elsewhere());
    if (this.#repeated > 0) {
      warnings.push(
        `Some parts stand in the scene several times; they are edited at their first place, and ${counted(this.#repeated, 'copy', 'copies')} will follow.`,
      );
    }
    return warnings;
  }
}
