import { at, WhittleError } from '../../mesh/failure.ts';
import { didYouMean } from '../../methods/suggest.ts';
import type { Image } from './image.ts';
import { findPattern, patternIds } from './patterns.ts';
import { isPng, readFinePng } from './png.ts';
import { type Texture, type TextureOptions, textureOf } from './texture.ts';

/** What it takes to read an image that is a file. */
export interface ImageReading {
  /** The bytes of a file that a recipe names. @throws Error whose sentence begins with the name */
  readonly readFile: (name: string) => Promise<Uint8Array<ArrayBuffer>>;
  /** @throws WhittleError */
  readonly decodeImage: (bytes: Uint8Array<ArrayBuffer>, name: string) => Promise<Image>;
}

/**
 * Makes a texture of what a recipe calls an image: a pattern of ours by its name, or an image file.
 *
 * @throws WhittleError `bad-parameter` for a name that is none, and as `textureOf` and the readers
 */
export async function readTexture(
  given: string,
  { readFile, decodeImage }: ImageReading,
  options: TextureOptions,
): Promise<Texture> {
  if (isPatternName(given)) return patternOf(given);
  const bytes = await readFile(given);
  return rememberedTexture(await at(given, decodeImage(bytes, given)), given, options);
}

/** True if a name means a pattern of ours, false if it means a file: that has a folder or an ending. */
function isPatternName(name: string): boolean {
  return patternIds.includes(name) || !/[./\\]/.test(name);
}

function patternOf(name: string): Texture {
  const pattern = findPattern(name);
  if (pattern) return pattern;
  throw new WhittleError(
    'bad-parameter',
    `There is no pattern “${name}”.${didYouMean(name, patternIds)} An image is named with its ending.`,
  );
}

/**
 * Decodes a PNG with all the precision that it has.
 *
 * @throws WhittleError `unsupported-file` for another kind of file, `malformed-file` for a broken one
 */
export async function decodePng(bytes: Uint8Array, name: string): Promise<Image> {
  if (isPng(bytes)) return readFinePng(bytes, name);
  throw new WhittleError(
    'unsupported-file',
    `${name} is not a PNG. Save the image as one: JPEG also blurs the normals that a normal map holds.`,
  );
}

const textures = new WeakMap<Image, Map<string, Texture>>();

/** The texture of an image, the same object for the same image and options. @throws WhittleError as `textureOf` */
export function rememberedTexture(image: Image, name: string, options: TextureOptions = {}): Texture {
  const { reading = 'auto', green = 'up' } = options;
  const ofImage = textures.get(image) ?? new Map<string, Texture>();
  textures.set(image, ofImage);
  const key = `${reading} ${green}`;
  const texture = ofImage.get(key) ?? textureOf(image, name, { reading, green });
  ofImage.set(key, texture);
  return texture;
}
