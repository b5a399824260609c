import { dirname, resolve } from 'node:path';
import type { Engine } from '../engine/client.ts';
import { readPng } from '../inputs/images/png.ts';
import { mapOfPixels } from '../inputs/styles/captures.ts';
import { type Mapping, resolveStyle, type StyleSource, styleNames } from '../inputs/styles/resolve.ts';
import { WhittleError } from '../mesh/failure.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { Directions, MethodDescriptor, ParameterValues, StyleParameter } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { findMethod } from '../methods/registry.ts';
import { checkParameters } from '../methods/values/check.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import { parseJson, type RecipeStep } from '../recipe/index.ts';
import { readBytes, readText } from './files.ts';
import { at, FileError } from './problems.ts';

/**
 * A step's parameters as the engine takes them: the style, by name, file or list of directions, as a Gauss map.
 *
 * @param recipe whose folder the file is looked for from, or undefined for the working directory
 * @throws WhittleError, FileError
 */
export async function withStyle(
  engine: Engine,
  { method: id, parameters }: RecipeStep,
  recipe: string | undefined,
): Promise<ParameterValues> {
  const method = findMethod(id);
  const descriptor = method?.parameters.find(({ kind }) => kind === 'style');
  if (!method || descriptor?.kind !== 'style') return parameters;
  const { [descriptor.name]: value = descriptor.default, mapping = descriptor.mapping ?? 'auto' } =
    parameters;
  // Only pages hand over Gauss maps; a recipe or a command line has a name or a list.
  const given = value as string | Directions;
  const map = await (isPicture(given) && descriptor.mapping === undefined
    ? captureOf(given, recipe)
    : resolved(engine, { method, descriptor, given, mapping: mapping as Mapping }, recipe));
  return { ...parameters, [descriptor.name]: map };
}

interface Asked {
  readonly method: MethodDescriptor;
  readonly descriptor: StyleParameter;
  readonly given: string | Directions;
  readonly mapping: Mapping;
}

async function resolved(engine: Engine, asked: Asked, recipe: string | undefined): Promise<GaussMap> {
  const { descriptor, given, mapping } = asked;
  const source = await sourceOf(engine, asked, recipe);
  const place =
    typeof given === 'string' && typeof source !== 'string' ? given : `--${kebabCase(descriptor.name)}`;
  return at(
    place,
    resolveStyle(source, mapping, (mesh) => flowed(engine, mesh)),
  );
}

function isPicture(given: string | Directions): given is string {
  return typeof given === 'string' && /\.png$/i.test(given);
}

async function captureOf(name: string, recipe: string | undefined): Promise<GaussMap> {
  const bytes = await readBytes(pathOf(name, recipe));
  return at(
    name,
    Promise.resolve().then(() => mapOfPixels(readPng(bytes, name))),
  );
}

/** A list, a name, or what a file holds: what has a folder or an ending and is no name is a mesh, or a list as JSON. */
async function sourceOf(
  engine: Engine,
  { method, descriptor, given }: Asked,
  recipe: string | undefined,
): Promise<StyleSource> {
  if (typeof given !== 'string' || styleNames.includes(given) || !/[./\\]/.test(given)) return given;
  const path = pathOf(given, recipe);
  if (/\.json$/i.test(given)) {
    const listed = parseJson(await readText(path), given);
    const problem = checkParameters(method, { [descriptor.name]: listed });
    if (problem) throw new WhittleError(problem.code, `${given}: ${problem.message}`);
    return listed as Directions;
  }
  if (/\.(jpe?g|webp)$/i.test(given)) {
    throw new FileError(
      `${given}: a normal capture is a PNG; save the picture as one, or give a mesh or a name.`,
    );
  }
  const { mesh } = await at(given, engine.read(await readBytes(path), path));
  return mesh;
}

/** What a recipe names lies beside it. */
export function pathOf(name: string, recipe: string | undefined): string {
  return recipe === undefined ? name : resolve(dirname(recipe), name);
}

async function flowed(engine: Engine, mesh: Mesh): Promise<Float64Array> {
  const settings = { method: 'spherical', parameters: {}, start: 'rest', frames: false } as const;
  try {
    return (await engine.solve(mesh, settings)).positions;
  } finally {
    engine.release(mesh);
  }
}
