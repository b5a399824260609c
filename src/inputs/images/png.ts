import { convertIndexedToRgb, type DecodedPng, decode, encode, hasPngSignature } from 'fast-png';
import { WhittleError } from '../../mesh/failure.ts';
import type { CapturePixels } from '../styles/captures.ts';

/** True if the bytes begin as a PNG does. */
export function isPng(bytes: Uint8Array): boolean {
  return bytes.length >= 8 && hasPngSignature(bytes.subarray(0, 8));
}

/** @throws WhittleError `malformed-file` if the bytes are not a whole PNG */
export function readPng(bytes: Uint8Array, name: string): CapturePixels {
  const png = decoded(bytes, name);
  return {
    width: png.width,
    height: png.height,
    data: rgba(png, new Uint8Array(4 * png.width * png.height), 255),
  };
}

/**
 * Decodes a PNG with all the precision that the file has, up to 16 bits: RGBA from 0 to `white`.
 *
 * @throws WhittleError as {@link readPng}
 */
export function readFinePng(bytes: Uint8Array, name: string) {
  const png = decoded(bytes, name);
  const { width, height } = png;
  const [Numbers, white] = png.depth === 16 ? ([Uint16Array, 65535] as const) : ([Uint8Array, 255] as const);
  return { width, height, white, data: rgba(png, new Numbers(4 * width * height), white) };
}

function decoded(bytes: Uint8Array, name: string): DecodedPng {
  try {
    return decode(bytes);
  } catch (thrown) {
    const why = thrown instanceof Error ? thrown.message : String(thrown);
    throw new WhittleError(
      'malformed-file',
      `${name} could not be read as a PNG (${why}). Save it again from an image editor, as PNG.`,
    );
  }
}

export function writePng({ width, height, data }: CapturePixels): Uint8Array<ArrayBuffer> {
  return new Uint8Array(encode({ width, height, data, depth: 8, channels: 4 }));
}

/** A PNG of one number a pixel. @param data 0 to 65535, rows from the top */
export function writeGreyPng(grey: {
  readonly width: number;
  readonly height: number;
  readonly data: Uint16Array;
}): Uint8Array<ArrayBuffer> {
  return new Uint8Array(encode({ ...grey, depth: 16, channels: 1 }));
}

/** Four numbers a pixel up to `white`, whatever the file has: grey or colour, with or without alpha, a palette, 1 to 16 bits. */
function rgba<Numbers extends Uint8Array | Uint16Array>(
  png: DecodedPng,
  out: Numbers,
  white: number,
): Numbers {
  const { width, height } = png;
  const { data, channels } = png.palette
    ? { data: convertIndexedToRgb(png), channels: png.palette[0]!.length }
    : png;
  const full = png.palette ? 255 : 2 ** png.depth - 1;
  const bits = png.palette ? 8 : png.depth;
  const value = (at: number): number =>
    (white * (bits < 8 ? bitsAt(data, at, bits, width) : data[at]!)) / full;
  out.fill(white);
  const isGrey = channels < 3;
  for (let pixel = 0; pixel < width * height; pixel++) {
    const at = pixel * channels;
    for (let k = 0; k < 3; k++) out[4 * pixel + k] = value(isGrey ? at : at + k);
    if (channels % 2 === 0) out[4 * pixel + 3] = value(at + channels - 1);
  }
  return out;
}

/** Greys of 1, 2 and 4 bits are packed, each row from a new byte. */
function bitsAt(data: ArrayLike<number>, pixel: number, bits: number, width: number): number {
  const perByte = 8 / bits;
  const [row, column] = [Math.floor(pixel / width), pixel % width];
  const byte = data[row * Math.ceil(width / perByte) + Math.floor(column / perByte)]!;
  return (byte >> (8 - bits * ((column % perByte) + 1))) & (2 ** bits - 1);
}
