import { WhittleError } from '../../mesh/failure.ts';
import { didYouMean } from '../../methods/suggest.ts';
import { findPattern, patternIds } from './patterns.ts';
import { isPng, readFinePng } from './png.ts';
import { type Texture, type TextureOptions, textureOf } from './texture.ts';

/** True if a name means a pattern of ours, false if it means a file: that has a folder or an ending. */
export function isPatternName(name: string): boolean {
  return patternIds.includes(name) || !/[./\\]/.test(name);
}

/** @throws WhittleError `bad-parameter` if there is no pattern of this name */
export function patternOf(name: string): Texture {
  const pattern = findPattern(name);
  if (pattern) return pattern;
  throw new WhittleError(
    'bad-parameter',
    `There is no pattern “${name}”.${didYouMean(name, patternIds)} A picture is named with its ending.`,
  );
}

/**
 * Reads the bytes of a PNG.
 *
 * @throws WhittleError `unsupported-file` for another kind of file and as `textureOf`, `malformed-file` for a broken one
 */
export function textureOfPng(bytes: Uint8Array, name: string, options?: TextureOptions): Texture {
  if (!isPng(bytes)) {
    throw new WhittleError(
      'unsupported-file',
      `${name} is not a PNG. Save the picture as one: JPEG also blurs the normals that a normal map holds.`,
    );
  }
  return textureOf(readFinePng(bytes, name), name, options);
}
