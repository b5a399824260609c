import { unzlibSync, zlibSync } from 'fflate';
import { crc32 } from '../../io/crc32.ts';
import { readPng, writePng } from '../images/png.ts';
import { pngChunks, withPngChunk } from '../images/png-chunks.ts';
import { blankMap, mapOfPixels, pixelsOfMap, type SphereMap } from './captures.ts';

/**
 * A painted ball as a file. The picture is a normal capture like any other: the front of the ball, eight bits a colour. A chunk of
 * our own behind it, `whGM`, holds what the picture loses, the back and all digits: the check sum of the picture's data (32 bits,
 * big-endian), then, as a zlib stream, the target normals of the captures' sphere, #P×3 doubles, little-endian, in its order.
 *
 * The chunk's name says what becomes of it elsewhere: lower case first, so that others may ignore it; upper case last, so that a
 * program that changes the picture has to drop it. Where one does not, the check sum no longer fits and the picture counts.
 */
const chunkType = 'whGM';

/** Pixels along the side of the picture. */
const pictureSize = 256;

/** The file of a painted ball, from which {@link mapOfCapture} gets the very same map. */
export function captureFile(map: SphereMap): Uint8Array<ArrayBuffer> {
  const png = writePng(pixelsOfMap(map, pictureSize));
  const packed = zlibSync(bytesOf(map.normals));
  const data = new Uint8Array(4 + packed.length);
  new DataView(data.buffer).setUint32(0, pictureSum(png));
  data.set(packed, 4);
  return withPngChunk(png, { type: chunkType, data });
}

/**
 * Reads a capture: a painted ball as it was painted, any other picture by its pixels.
 *
 * @throws WhittleError `malformed-file` if it is no whole PNG, and as `mapOfPixels`
 */
export function mapOfCapture(png: Uint8Array, name: string): SphereMap {
  const pixels = readPng(png, name);
  return exactMap(png) ?? mapOfPixels(pixels);
}

function exactMap(png: Uint8Array): SphereMap | undefined {
  const chunk = pngChunks(png).find(({ type }) => type === chunkType);
  if (!chunk || chunk.data.length < 4 || viewOf(chunk.data).getUint32(0) !== pictureSum(png))
    return undefined;
  const blank = blankMap();
  const normals = unpacked(chunk.data.subarray(4), blank.normals.length);
  return normals && { ...blank, normals };
}

function unpacked(packed: Uint8Array, count: number): Float64Array<ArrayBuffer> | undefined {
  try {
    const bytes = unzlibSync(packed, { out: new Uint8Array(8 * count) });
    const view = viewOf(bytes);
    const normals = Float64Array.from({ length: count }, (_, k) => view.getFloat64(8 * k, true));
    return bytes.length === 8 * count && normals.every(Number.isFinite) ? normals : undefined;
  } catch {
    return undefined;
  }
}

function bytesOf(numbers: Float64Array): Uint8Array {
  const bytes = new Uint8Array(8 * numbers.length);
  const view = viewOf(bytes);
  for (const [k, value] of numbers.entries()) view.setFloat64(8 * k, value, true);
  return bytes;
}

function pictureSum(png: Uint8Array): number {
  const picture = pngChunks(png).filter(({ type }) => type === 'IDAT');
  return picture.reduce((sum, { data }) => crc32(data, sum), 0);
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
