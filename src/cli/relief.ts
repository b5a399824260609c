import type { ReadResult } from '../engine/protocol.ts';
import { patternIds } from '../inputs/images/patterns.ts';
import { isPatternName, patternOf, textureOfPng } from '../inputs/images/read.ts';
import type { Texture, TextureOptions } from '../inputs/images/texture.ts';
import { legibility, type ReliefOptions, reliefOf, tooFine } from '../inputs/images/texture-slopes.ts';
import { WhittleError } from '../mesh/failure.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { ParameterValues } from '../methods/descriptor.ts';
import { findMethod } from '../methods/registry.ts';
import type { RecipeStep } from '../recipe/index.ts';
import { readBytes } from './files.ts';
import { at } from './problems.ts';
import { pathOf } from './style.ts';

/** A mesh, and the normal map that its file has inside. */
export interface TexturedSurface {
  readonly mesh: Mesh;
  readonly normalMap: ReadResult['normalMap'];
}

/**
 * A step's parameters as the engine takes them: the picture, by name or file or from inside the mesh's file, as a relief on the mesh.
 *
 * @param place what sentences about the mesh begin with
 * @param recipe whose folder the file is looked for from, or undefined for the working directory
 * @returns the parameters, and a sentence if the mesh is too coarse for the picture
 * @throws WhittleError, FileError
 */
export async function withRelief(
  { mesh, normalMap }: TexturedSurface,
  place: string,
  { method, parameters }: RecipeStep,
  recipe: string | undefined,
): Promise<{ parameters: ParameterValues; warnings: readonly string[] }> {
  const descriptor = findMethod(method)?.parameters.find(({ kind }) => kind === 'relief');
  if (!descriptor) return { parameters, warnings: [] };
  const { name } = descriptor;
  const { repeat, ...options } = parameters as TextureOptions & ReliefOptions;
  const texture = await textureOf(parameters[name], normalMap, options, recipe);
  const relief = await at(
    place,
    Promise.resolve().then(() => reliefOf(texture, mesh, { repeat })),
  );
  const warning = tooFine(legibility(texture, mesh, { repeat }));
  return { parameters: { ...parameters, [name]: relief }, warnings: warning === undefined ? [] : [warning] };
}

/** @param image by name, or undefined for the one inside the mesh's file */
async function textureOf(
  image: unknown,
  own: TexturedSurface['normalMap'],
  options: TextureOptions,
  recipe: string | undefined,
): Promise<Texture> {
  if (typeof image === 'string') {
    if (isPatternName(image)) return patternOf(image);
    return textureOfPng(await readBytes(pathOf(image, recipe)), image, options);
  }
  if (own) return textureOfPng(own.bytes, `The file’s own normal map “${own.name}”`, options);
  const sentence = `normalmap needs a picture; give as “image” a PNG, such as map.png, or a pattern: ${patternIds.join(', ')}.`;
  throw new WhittleError('bad-parameter', sentence);
}
