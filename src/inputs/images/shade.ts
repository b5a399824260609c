import { Pyramid } from './pyramid.ts';
import type { Texture } from './texture.ts';

/** The texture as a lit surface seen from above, for thumbnails: light from the upper left, grey levels as RGBA bytes. */
export function shaded(texture: Texture, size: number): Uint8ClampedArray<ArrayBuffer> {
  const pyramid = new Pyramid(texture);
  const level = Math.log2(Math.max(texture.width, texture.height) / size);
  const data = new Uint8ClampedArray(4 * size * size).fill(255);
  const slope = new Float64Array(2);
  for (let j = 0; j < size; j++)
    for (let i = 0; i < size; i++) {
      pyramid.sample((i + 0.5) / size, 1 - (j + 0.5) / size, level, slope);
      const light = (0.42 * slope[0]! - 0.52 * slope[1]! + 0.75) / Math.hypot(slope[0]!, slope[1]!, 1);
      data.fill(255 * (0.1 + 0.84 * Math.max(0, light)), 4 * (j * size + i), 4 * (j * size + i) + 3);
    }
  return data;
}
