import { describe, expect, it } from 'vitest';
import { readPng } from '../../src/inputs/images/png.ts';
import { pngChunks, withPngChunk } from '../../src/inputs/images/png-chunks.ts';
import { decodePng } from '../../src/inputs/images/read.ts';
import { mapOfPixels, pixelsOfMap, sphereMap } from '../../src/inputs/styles/captures.ts';
import { captureFile, mapOfCapture } from '../../src/inputs/styles/exact-capture.ts';
import { unit } from '../../src/mesh/vectors.ts';

/** Its back is not the mirror image of its front. */
const painted = sphereMap(([x, y, z]) => unit([x, y + 0.4, 0.5 * z - 0.3]));
const file = captureFile(painted);

describe('the file of a painted ball', () => {
  it('gives the very same map back, with the back that its picture does not show', () => {
    expect(mapOfCapture(file, 'painted.png')).toEqual(painted);
    expect(mapOfPixels(readPng(file, 'painted.png')).normals).not.toEqual(painted.normals);
  });

  it('is a picture for others', async () => {
    const { data } = pixelsOfMap(painted, 256);
    expect((await decodePng(file, 'painted.png')).data).toEqual(new Uint8Array(data));
    expect(pngChunks(file).map(({ type }) => type)).toEqual(['IHDR', 'IDAT', 'whGM', 'IEND']);
  });

  it('counts by its pixels once these were changed, and where the chunk is broken', () => {
    const other = captureFile(sphereMap((normal) => normal));
    const chunk = pngChunks(file).find(({ type }) => type === 'whGM')!;
    const plain = withoutChunk(other);
    const stale = withPngChunk(plain, chunk);
    const byPixels = mapOfPixels(readPng(other, 'a.png'));
    expect(mapOfCapture(plain, 'a.png')).toEqual(byPixels);
    expect(mapOfCapture(stale, 'a.png')).toEqual(byPixels);
    const own = pngChunks(other).find(({ type }) => type === 'whGM')!;
    for (const data of [own.data.subarray(0, 3), own.data.subarray(0, 900), own.data.slice().fill(7, 4)])
      expect(mapOfCapture(withPngChunk(plain, { type: 'whGM', data }), 'a.png')).toEqual(byPixels);
  });
});

function withoutChunk(png: Uint8Array): Uint8Array<ArrayBuffer> {
  const { data } = pngChunks(png).find(({ type }) => type === 'whGM')!;
  const begin = png.length - 12 - data.length - 12;
  return new Uint8Array(Buffer.concat([png.subarray(0, begin), png.subarray(png.length - 12)]));
}
