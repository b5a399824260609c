import { crc32 } from '../../io/crc32.ts';

/** A piece of a PNG: four letters and what they hold. */
export interface PngChunk {
  readonly type: string;
  readonly data: Uint8Array;
}

const signatureLength = 8;
/** Length and type before the data, the check sum behind it. */
const overhead = 12;

/** The pieces of a whole PNG, as far as they are there. */
export function pngChunks(png: Uint8Array): readonly PngChunk[] {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  const chunks: PngChunk[] = [];
  for (let at = signatureLength; at + overhead <= png.length; ) {
    const end = at + 8 + view.getUint32(at);
    if (end + 4 > png.length) break;
    const type = String.fromCharCode(...png.subarray(at + 4, at + 8));
    chunks.push({ type, data: png.subarray(at + 8, end) });
    at = end + 4;
  }
  return chunks;
}

/** The PNG with one more piece, before its end. */
export function withPngChunk(png: Uint8Array, { type, data }: PngChunk): Uint8Array<ArrayBuffer> {
  const end = png.length - overhead;
  const result = new Uint8Array(png.length + overhead + data.length);
  const view = new DataView(result.buffer);
  result.set(png.subarray(0, end));
  view.setUint32(end, data.length);
  for (let k = 0; k < 4; k++) result[end + 4 + k] = type.charCodeAt(k);
  result.set(data, end + 8);
  view.setUint32(end + 8 + data.length, crc32(result.subarray(end + 4, end + 8 + data.length)));
  result.set(png.subarray(end), end + overhead + data.length);
  return result;
}
