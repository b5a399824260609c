import { imageType } from '../look/look.ts';
import { decodeBase64, encodeBase64 } from './base64.ts';
import type { GltfDocument, Json } from './document.ts';

/** An image of a glTF file. */
export interface GltfImage {
  /** As the file calls it, or the path to it; '' if it has neither. */
  readonly name: string;
  /** Absent where it is not to be had: it lies beside the file and was not given, or is broken. */
  readonly bytes?: Uint8Array<ArrayBuffer> | undefined;
}

/** Image `index` of a file. What is not needed for the shape is no reason to refuse it: what is not there is empty. */
export function imageOf(document: GltfDocument, index: unknown): GltfImage {
  const { name, uri, bufferView } = elementOf(document, 'images', index);
  const path = typeof uri === 'string' && !/^data:/i.test(uri) ? document.pathOf(uri) : undefined;
  const isNamed = typeof name === 'string' && name !== '';
  return {
    name: isNamed ? name : (path ?? ''),
    bytes: typeof uri === 'string' ? bytesOfUri(document, uri, path) : bytesOfView(document, bufferView),
  };
}

/** The data URI of an image that is beside the file; undefined where it is not there or of a kind that is not known. */
export function imageInside(document: GltfDocument, path: string): string | undefined {
  const bytes = document.beside(path);
  const type = bytes && imageType(bytes);
  return type && `data:${type};base64,${encodeBase64(bytes)}`;
}

/** The image that a texture shows, by its index. */
export function imageOfTexture(document: GltfDocument, texture: unknown): number | undefined {
  const { source } = elementOf(document, 'textures', texture);
  return typeof source === 'number' ? source : undefined;
}

/** An element of a list of the document, or an empty one. */
export function elementOf(document: GltfDocument, key: string, index: unknown): Json {
  const list = document.root[key];
  return recordOf(Array.isArray(list) && typeof index === 'number' ? list[index] : undefined);
}

export function recordOf(value: unknown): Json {
  return typeof value === 'object' && value !== null ? (value as Json) : {};
}

function bytesOfUri(document: GltfDocument, uri: string, path?: string): Uint8Array<ArrayBuffer> | undefined {
  if (path !== undefined) return document.beside(path)?.slice();
  const comma = uri.indexOf(',');
  return /;base64$/i.test(uri.slice(0, comma)) ? decodeBase64(uri.slice(comma + 1)) : undefined;
}

function bytesOfView(document: GltfDocument, index: unknown): Uint8Array<ArrayBuffer> | undefined {
  const { buffer, byteOffset = 0, byteLength } = elementOf(document, 'bufferViews', index);
  const isPlace = [buffer, byteOffset, byteLength].every((number) => Number.isSafeInteger(number));
  if (!isPlace) return undefined;
  try {
    const begin = byteOffset as number;
    return document.buffer(buffer as number).slice(begin, begin + (byteLength as number));
  } catch {
    return undefined;
  }
}
