import { concatenate } from '../bytes.ts';
import { splitByUv } from '../look/corners.ts';
import { imageType, type Look, type Material } from '../look/look.ts';
import type { Shape } from '../parsed-file.ts';
import { packGlb, packGltf, paddedPieces } from './pack.ts';

/**
 * A new GLB: positions rounded to 32 bits, and what there is of colours, texture coordinates, materials with their textures, and
 * named parts, a mesh each. Without normals, viewers shade it flat.
 */
export function writeGlb(shape: Shape): Uint8Array<ArrayBuffer> {
  return packGlb(new GltfFileMaker(shape).make());
}

/** A new glTF as one JSON file with its data inside: what `writeGlb` makes, in text. */
export function writeGltf(shape: Shape): Uint8Array<ArrayBuffer> {
  return packGltf(new GltfFileMaker(shape).make());
}

const float32 = 5126;
const uint32 = 5125;
const vertexData = 34962;
const indexData = 34963;

/** Faces of one name and material. */
interface Primitive {
  readonly name: string;
  readonly material: number | undefined;
  readonly indices: number[];
}

class GltfFileMaker {
  readonly #shape: Shape;
  readonly #pieces: Uint8Array[] = [];
  readonly #views: object[] = [];
  readonly #accessors: object[] = [];
  readonly #images: object[] = [];
  #length = 0;

  constructor(shape: Shape) {
    this.#shape = shape;
  }

  make(): { json: object; bin: Uint8Array } {
    const { uvs, look } = this.#shape;
    const vertexOf = this.#vertices(uvs);
    const attributes = this.#attributes(vertexOf.positionOfVertex, vertexOf.uvs);
    const primitives = primitivesOf(this.#shape, vertexOf.vertexOfTriangleCorner);
    const names = [...new Set(primitives.map(({ name }) => name))];
    const meshes = names.map((name) => ({
      ...(name === '' ? {} : { name }),
      primitives: primitives
        .filter((primitive) => primitive.name === name)
        .map(({ material, indices }) => ({
          ...{ attributes, indices: this.#indices(indices) },
          ...(material === undefined ? {} : { material }),
        })),
    }));
    const materials = look.materials.map((material) => this.#material(material));
    const textures = this.#images.map((_, source) => ({ source }));
    const json = {
      asset: { version: '2.0', generator: 'Whittle' },
      ...{ scene: 0, scenes: [{ nodes: names.map((_, i) => i) }] },
      nodes: names.map((name, mesh) => ({ ...(name === '' ? {} : { name }), mesh })),
      ...{ meshes, accessors: this.#accessors, bufferViews: this.#views },
      ...(materials.length > 0 ? { materials } : {}),
      ...(textures.length > 0 ? { textures, images: this.#images } : {}),
      buffers: [{ byteLength: this.#length }],
    };
    return { json, bin: concatenate(paddedPieces(this.#pieces)) };
  }

  /** One vertex for each position, or for each pair of texture coordinates that it has. */
  #vertices(uvs: Float32Array | undefined) {
    const { positions, triangles, triangleCorners } = this.#shape;
    if (!uvs) {
      const positionOfVertex = Uint32Array.from({ length: positions.length / 3 }, (_, p) => p);
      return { positionOfVertex, vertexOfTriangleCorner: triangles };
    }
    const split = splitByUv(this.#shape, uvs);
    return {
      positionOfVertex: split.positionOfVertex,
      uvs: split.uvs,
      vertexOfTriangleCorner: triangleCorners.map((corner) => split.vertexOfCorner[corner]),
    };
  }

  #attributes(positionOfVertex: Uint32Array, uvs: Float32Array | undefined): object {
    const { positions, colors } = this.#shape;
    const gathered = (values: ArrayLike<number>) =>
      new Float32Array(3 * positionOfVertex.length).map(
        (_, i) => values[3 * positionOfVertex[Math.floor(i / 3)] + (i % 3)],
      );
    const place = gathered(positions);
    // glTF counts v downward, and has texture coordinates at every vertex or at none.
    const flipped = uvs?.map((value, i) => (Number.isNaN(value) ? 0 : i % 2 === 0 ? value : 1 - value));
    return {
      POSITION: this.#accessor(place, 'VEC3', boundsOf(place)),
      ...(flipped ? { TEXCOORD_0: this.#accessor(flipped, 'VEC2') } : {}),
      ...(colors ? { COLOR_0: this.#accessor(gathered(colors), 'VEC3') } : {}),
    };
  }

  #accessor(values: Float32Array, type: 'VEC2' | 'VEC3', bounds: object = {}): number {
    const bufferView = this.#view(littleEndian(values), vertexData);
    const count = values.length / Number(type.slice(3));
    return this.#accessors.push({ bufferView, componentType: float32, count, type, ...bounds }) - 1;
  }

  #indices(indices: readonly number[]): number {
    const bufferView = this.#view(littleEndian(Uint32Array.from(indices)), indexData);
    return (
      this.#accessors.push({ bufferView, componentType: uint32, count: indices.length, type: 'SCALAR' }) - 1
    );
  }

  #material({ name, color, texture }: Material): object {
    const bytes = texture?.bytes;
    const mimeType = bytes && imageType(bytes);
    const baseColorTexture = mimeType && { index: this.#image(texture.name, mimeType, bytes) };
    return {
      name,
      pbrMetallicRoughness: {
        ...(color ? { baseColorFactor: color } : {}),
        ...(baseColorTexture ? { baseColorTexture } : {}),
        metallicFactor: 0,
      },
      ...(color && color[3] < 1 ? { alphaMode: 'BLEND' } : {}),
    };
  }

  /** Materials that share an image share it in the new file too. */
  #image(name: string, mimeType: string, bytes: Uint8Array): number {
    const known = this.#pieces.indexOf(bytes);
    const bufferView = known >= 0 ? known : this.#view(bytes);
    const same = this.#images.findIndex((image) => 'bufferView' in image && image.bufferView === bufferView);
    return same >= 0 ? same : this.#images.push({ name, mimeType, bufferView }) - 1;
  }

  #view(bytes: Uint8Array, target?: number): number {
    const view = {
      buffer: 0,
      byteOffset: this.#length,
      byteLength: bytes.length,
      ...(target ? { target } : {}),
    };
    this.#pieces.push(bytes);
    this.#length += 4 * Math.ceil(bytes.length / 4);
    return this.#views.push(view) - 1;
  }
}

/** Triangles by name and material, in the order in which these come first. */
function primitivesOf({ faces, look, triangles }: Shape, vertexOfTriangleCorner: Uint32Array): Primitive[] {
  const found = new Map<string, Primitive>();
  const parts: Look['parts'] = look.parts.length > 0 ? look.parts : [{ firstFace: 0, name: '' }];
  // A polygon of n corners gives n − 2 triangles.
  const cornersBefore = (face: number) => 3 * (faces.start[face] - 2 * face);
  parts.forEach(({ firstFace, name, material }, i) => {
    const key = JSON.stringify([name, material]);
    const primitive = found.get(key) ?? { name, material, indices: [] };
    found.set(key, primitive);
    const end = i + 1 < parts.length ? cornersBefore(parts[i + 1].firstFace) : triangles.length;
    for (let c = cornersBefore(firstFace); c < end; c++) primitive.indices.push(vertexOfTriangleCorner[c]);
  });
  return [...found.values()];
}

function littleEndian(values: Float32Array | Uint32Array): Uint8Array {
  const bytes = new Uint8Array(4 * values.length);
  const view = new DataView(bytes.buffer);
  if (values instanceof Float32Array) values.forEach((value, i) => void view.setFloat32(4 * i, value, true));
  else values.forEach((value, i) => void view.setUint32(4 * i, value, true));
  return bytes;
}

/** The smallest and largest of the positions. */
function boundsOf(positions: Float32Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    min[i % 3] = Math.min(min[i % 3], positions[i]);
    max[i % 3] = Math.max(max[i % 3], positions[i]);
  }
  return { min, max };
}
