import type { EmbeddedImage } from '../parsed-file.ts';
import type { GltfDocument } from './document.ts';
import { elementOf, imageOf, imageOfTexture, recordOf } from './images.ts';

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

  /** The image that all parts share; undefined if they share none, or if it is not there. */
  found(): EmbeddedImage | undefined {
    const [image] = this.#images;
    if (this.#images.size !== 1 || image === undefined) return undefined;
    const { name, bytes } = imageOf(this.#document, image);
    return bytes && { name: name || 'normal map', bytes };
  }

  #imageOf(material: unknown): number | undefined {
    const texture = recordOf(elementOf(this.#document, 'materials', material).normalTexture);
    // Only the first set of coordinates is read.
    if (texture.texCoord !== undefined && texture.texCoord !== 0) return undefined;
    return imageOfTexture(this.#document, texture.index);
  }
}
