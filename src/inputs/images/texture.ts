import { WhittleError } from '../../mesh/failure.ts';
import type { Image } from './image.ts';

/**
 * What an image says of a surface: how it rises at every pixel. Slopes can be averaged, as normals cannot: the mean slope of a
 * patch is the slope of the mean height.
 */
export interface Texture {
  readonly width: number;
  readonly height: number;
  /** Rise to the right and rise upward of each pixel, rows from the top, 2·width·height numbers; a number of 1 is 45°. */
  readonly slopes: Float32Array;
}

export interface TextureOptions {
  /** Whether colours are tangent-space normals or brightness is height; auto tells them apart. Default `auto`. */
  readonly reading?: 'auto' | 'normals' | 'height' | undefined;
  /** Which way green points in a normal map: along growing v, or against it as in DirectX. Default `up`. */
  readonly green?: 'up' | 'down' | undefined;
}

/** White stands so much above black, as a share of the image's width. */
export const heightOfWhite = 1 / 20;

/** Larger images are more than any mesh can show. */
const mostPixels = 2 ** 24;
/** Colours this near to a unit vector's are read as one. */
const unitTolerance = 0.15;
/** So many of an image's pixels must be normals for auto to take it for a normal map, and for `normals` to take it at all. */
const shareOfMap = 0.9;
const leastShare = 0.5;
/** Normals that lean more than this have slopes without end. */
const steepest = 10;

/**
 * Reads an image.
 *
 * @param name for the message
 * @throws WhittleError `unsupported-file` if it is too large or empty, or no normal map although it is to be read as one
 */
export function textureOf(image: Image, name: string, options: TextureOptions = {}): Texture {
  const { width, height } = image;
  if (!(width > 0 && height > 0 && width * height <= mostPixels)) {
    const sentence = `the image has ${width} × ${height} pixels; scale it to at most 4096 on a side.`;
    throw new WhittleError('unsupported-file', `${name}: ${sentence}`);
  }
  const { reading = 'auto', green = 'up' } = options;
  const share = reading === 'height' ? 0 : shareOfNormals(image);
  if (reading === 'normals' && share < leastShare) {
    const sentence = `only ${Math.floor(100 * share)} % of its pixels are normals, so it is no normal map; read it as height, or leave that to auto.`;
    throw new WhittleError('unsupported-file', `${name}: ${sentence}`);
  }
  const isNormals = reading === 'normals' || share >= shareOfMap;
  const slopes = isNormals ? slopesOfNormals(image, green === 'up' ? 1 : -1) : slopesOfHeights(image);
  return { width, height, slopes };
}

/** The texture of heights in image widths, one a pixel, that go on beyond each edge as they begin at the other. */
export function textureOfHeights(width: number, height: number, heights: ArrayLike<number>): Texture {
  const slopes = new Float32Array(2 * width * height);
  for (let j = 0; j < height; j++) {
    const above = width * (j === 0 ? height - 1 : j - 1);
    const below = width * (j === height - 1 ? 0 : j + 1);
    for (let i = 0; i < width; i++) {
      const here = width * j;
      const left = here + (i === 0 ? width - 1 : i - 1);
      const right = here + (i === width - 1 ? 0 : i + 1);
      slopes[2 * (here + i)] = ((heights[right]! - heights[left]!) / 2) * width;
      slopes[2 * (here + i) + 1] = ((heights[above + i]! - heights[below + i]!) / 2) * width;
    }
  }
  return { width, height, slopes };
}

/** A colour's number as a coordinate; both bytes in the middle, 127 and 128, are 0, as painters of flat maps mean them. */
function coordinate(value: number, white: number): number {
  const x = (2 * value) / white - 1;
  return Math.abs(Math.abs(x) - 1 / 255) < 1e-6 ? 0 : x;
}

/** The share of normals among the pixels that can be seen. A mid grey is no normal, and none points into the surface. */
function shareOfNormals({ data, white }: Image): number {
  let seen = 0;
  let good = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3]! < 0.5 * white) continue;
    seen++;
    const x = coordinate(data[at]!, white);
    const y = coordinate(data[at + 1]!, white);
    const z = coordinate(data[at + 2]!, white);
    if (z > 0 && Math.abs(Math.sqrt(x * x + y * y + z * z) - 1) <= unitTolerance) good++;
  }
  return seen === 0 ? 0 : good / seen;
}

function slopesOfNormals({ data, white }: Image, greenSign: number): Float32Array {
  const slopes = new Float32Array(data.length / 2);
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3]! < 0.5 * white) continue; // nothing is painted there: flat
    const x = coordinate(data[at]!, white);
    const y = greenSign * coordinate(data[at + 1]!, white);
    const z = Math.max(coordinate(data[at + 2]!, white), Math.sqrt(x * x + y * y) / steepest);
    if (z === 0) continue;
    slopes[at / 2] = -x / z + 0; // no −0
    slopes[at / 2 + 1] = -y / z + 0;
  }
  return slopes;
}

function slopesOfHeights({ width, height, data, white }: Image): Texture['slopes'] {
  const heights = new Float32Array(width * height);
  for (let pixel = 0; pixel < heights.length; pixel++) {
    const at = 4 * pixel;
    const brightness = 0.2126 * data[at]! + 0.7152 * data[at + 1]! + 0.0722 * data[at + 2]!;
    heights[pixel] = (heightOfWhite * brightness * data[at + 3]!) / (white * white);
  }
  return textureOfHeights(width, height, heights).slopes;
}
