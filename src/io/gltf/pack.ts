import { concatenate, encodeUtf8, viewOf } from '../bytes.ts';
import { imageType } from '../look/look.ts';
import { encodeBase64 } from './base64.ts';
import type { GltfDocument, Json } from './document.ts';
import { imageOf } from './images.ts';

/** A glTF asset that has one buffer at most, and its bytes. */
export interface GltfPieces {
  readonly json: object;
  readonly bin: Uint8Array;
}

/** A GLB of an asset. */
export function packGlb({ json, bin }: GltfPieces): Uint8Array<ArrayBuffer> {
  const text = encodeUtf8(JSON.stringify(json));
  const textLength = 4 * Math.ceil(text.length / 4);
  const binLength = 4 * Math.ceil(bin.length / 4);
  const result = new Uint8Array(12 + 8 + textLength + 8 + binLength);
  const view = viewOf(result);
  view.setUint32(0, 0x46546c67, true); // "glTF"
  view.setUint32(4, 2, true);
  view.setUint32(8, result.length, true);
  view.setUint32(12, textLength, true);
  view.setUint32(16, 0x4e4f534a, true); // "JSON"
  result.fill(32, 20, 20 + textLength);
  result.set(text, 20);
  view.setUint32(20 + textLength, binLength, true);
  view.setUint32(24 + textLength, 0x004e4942, true); // "BIN"
  result.set(bin, 28 + textLength);
  return result;
}

/** An asset as one JSON file with its data inside. */
export function packGltf({ json, bin }: GltfPieces): Uint8Array<ArrayBuffer> {
  const uri = `data:application/octet-stream;base64,${encodeBase64(bin)}`;
  const buffers = bin.length > 0 ? { buffers: [{ byteLength: bin.length, uri }] } : {};
  return encodeUtf8(JSON.stringify({ ...json, ...buffers }));
}

/**
 * Gathers all data of an asset in one buffer, images of other files too where they are there: what a glTF becomes as GLB
 * and the other way round. Nothing else changes.
 */
export function piecesOf(document: GltfDocument): GltfPieces {
  const { root } = document;
  const list = (key: string) => document.list(root, key) as readonly Json[];
  const pieces = list('buffers').map((_, i) => document.buffer(i));
  const offsets: number[] = [];
  let length = 0;
  const place = (piece: Uint8Array) => {
    offsets.push(length);
    length += 4 * Math.ceil(piece.length / 4);
  };
  pieces.forEach(place);
  const views: Json[] = list('bufferViews').map((view) => {
    const from = document.count(view.byteOffset, 'buffer view');
    return { ...view, buffer: 0, byteOffset: offsets[document.count(view.buffer, 'buffer view')] + from };
  });
  const images = list('images').map((image, i) => {
    const { bytes } = image.uri === undefined ? { bytes: undefined } : imageOf(document, i);
    const mimeType = bytes && imageType(bytes);
    if (!bytes || !mimeType) return image;
    const { uri, ...rest } = image;
    place(bytes);
    pieces.push(bytes);
    views.push({ buffer: 0, byteOffset: offsets.at(-1)!, byteLength: bytes.length });
    return { ...rest, mimeType, bufferView: views.length - 1 };
  });
  const json = {
    ...root,
    ...(views.length > 0 ? { bufferViews: views } : {}),
    ...(images.length > 0 ? { images } : {}),
    buffers: [{ byteLength: length }],
  };
  return { json, bin: concatenate(paddedPieces(pieces)) };
}

/** Pieces of bytes, each followed by zeros to a multiple of four. */
export function paddedPieces(pieces: readonly Uint8Array[]): Uint8Array[] {
  return pieces.flatMap((piece) => [piece, new Uint8Array((4 - (piece.length % 4)) % 4)]);
}
