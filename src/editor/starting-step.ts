import { findPattern, patternIds } from '../inputs/images/patterns.ts';
import { startingValues } from '../inputs/starting-values.ts';
import type { Mapping } from '../inputs/styles/resolve.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import type { StyleParameter } from '../methods/values/style.ts';
import type { RecipeStep, Resolver } from '../recipe/index.ts';
import type { OpenedFile } from './open-file.ts';

/** The parameter by which a method borrows from a style, if it does. */
export function styleParameter(method: MethodDescriptor | undefined): StyleParameter | undefined {
  return method?.parameters.find(({ kind }) => kind === 'style') as StyleParameter | undefined;
}

/** The parameter by which a method takes an image, if it does. */
export function imageParameter(method: MethodDescriptor | undefined): string | undefined {
  return method?.parameters.find(({ kind }) => kind === 'textureSlopes')?.name;
}

/**
 * The step that a method begins as on a mesh: what is given, and for all else what suits the mesh, the style and the image.
 *
 * @throws WhittleError as the given style cannot be read
 */
export async function startingStep(
  method: MethodDescriptor,
  given: ParameterValues,
  { mesh, report, source }: Pick<OpenedFile, 'mesh' | 'report' | 'source'>,
  resolver: Resolver,
): Promise<RecipeStep> {
  const borrowed: Record<string, ParameterValues[string]> = {};
  const parameter = styleParameter(method);
  if (parameter) borrowed[parameter.name] = given[parameter.name] ?? parameter.default;
  const image = imageParameter(method);
  // A normal map inside the file needs no name; where there is none, a pattern of ours has to do.
  if (image && !source.normalMap) borrowed[image] = given[image] ?? patternIds[0]!;
  const style = parameter ? await mapOf(parameter, { ...given, ...borrowed }, resolver) : null;
  const name = image && (given[image] ?? borrowed[image]);
  const pattern = (typeof name === 'string' && findPattern(name)) || null;
  const values = startingValues(method, { mesh, report, style, pattern });
  return { method: method.id, parameters: { ...values, ...borrowed, ...given } };
}

async function mapOf(
  parameter: StyleParameter,
  values: ParameterValues,
  resolver: Resolver,
): Promise<GaussMap> {
  const value = values[parameter.name];
  if (typeof value !== 'string') return value as GaussMap;
  const mapping = (values.mapping ?? parameter.mapping ?? 'auto') as Mapping;
  return resolver.gaussMap(parameter, value, mapping);
}
