import type { EmbeddedImage } from '../parsed-file.ts';
import { decodeBase64 } from './base64.ts';
import type { GltfDocument, Json } from './document.ts';

/** Finds the one normal map of all parts of a scene, if there is one. */
export class NormalMapSearch {
  readonly #document: GltfDocument;
  /** The image of every part that has texture coordinates; undefined for one without a normal map. */
  readonly #images = new Set<number | undefined>();

  constructor(document: GltfDocument) {
    this.#document = document;
  }

  /** Looks at the material of a part that has texture coordinates. */
  add(material: unknown): void {
    this.#images.add(this.#imageOf(material));
  }

  /** The image that all parts share; undefined if they share none, or if it is not in the file. */
  found(): EmbeddedImage | undefined {
    const [image] = this.#images;
    if (this.#images.size !== 1 || image === undefined) return undefined;
    const { name, uri, bufferView } = this.#element('images', image);
    const bytes = typeof uri === 'string' ? bytesOfUri(uri) : this.#bytesOfView(bufferView);
    const isNamed = typeof name === 'string' && name !== '';
    return bytes && { name: isNamed ? name : 'normal map', bytes };
  }

  #imageOf(material: unknown): number | undefined {
    const texture = recordOf(this.#element('materials', material).normalTexture);
    // Only the first set of coordinates is read.
    if (texture.texCoord !== undefined && texture.texCoord !== 0) return undefined;
    const { source } = this.#element('textures', texture.index);
    return typeof source === 'number' ? source : undefined;
  }

  #bytesOfView(index: unknown): Uint8Array<ArrayBuffer> | undefined {
    const { buffer, byteOffset = 0, byteLength } = this.#element('bufferViews', index);
    const isPlace = [buffer, byteOffset, byteLength].every((number) => Number.isSafeInteger(number));
    if (!isPlace) return undefined;
    try {
      const begin = byteOffset as number;
      return this.#document.buffer(buffer as number).slice(begin, begin + (byteLength as number));
    } catch {
      return undefined;
    }
  }

  /** What is not needed for the shape is no reason to refuse the file: what is not there is empty. */
  #element(key: string, index: unknown): Json {
    const list = this.#document.root[key];
    return recordOf(Array.isArray(list) && typeof index === 'number' ? list[index] : undefined);
  }
}

function recordOf(value: unknown): Json {
  return typeof value === 'object' && value !== null ? (value as Json) : {};
}

function bytesOfUri(uri: string): Uint8Array<ArrayBuffer> | undefined {
  const comma = uri.indexOf(',');
  return /^data:.*;base64$/i.test(uri.slice(0, comma)) ? decodeBase64(uri.slice(comma + 1)) : undefined;
}
