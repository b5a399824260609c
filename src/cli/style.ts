import { dirname, resolve } from 'node:path';
import type { Engine } from '../engine/client.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { ParameterValues } from '../methods/descriptor.ts';
import type { GaussMap } from '../methods/gauss-map.ts';
import { findMethod } from '../methods/registry.ts';
import type { RecipeStep } from '../recipe/index.ts';
import { mapOfPixels } from '../styles/captures.ts';
import { readPng } from '../styles/png.ts';
import { type Mapping, resolveStyle, type StyleSource, styleNames } from '../styles/resolve.ts';
import { readBytes } from './files.ts';
import { at, FileError } from './problems.ts';

/**
 * A step's parameters as the engine takes them: the style, by name or file, as a Gauss map.
 *
 * @param recipe whose folder the file is looked for from, or undefined for the working directory
 * @throws WhittleError, FileError
 */
export async function withStyle(
  engine: Engine,
  { method, parameters }: RecipeStep,
  recipe: string | undefined,
): Promise<ParameterValues> {
  const descriptor = findMethod(method)?.parameters.find(({ kind }) => kind === 'style');
  if (descriptor?.kind !== 'style') return parameters;
  const { style = descriptor.default, mapping = 'auto' } = parameters;
  // Only pages hand over Gauss maps; a recipe or a command line has a name.
  const name = style as string;
  const map = await (isPicture(name)
    ? captureOf(name, recipe)
    : resolved(engine, name, mapping as Mapping, recipe));
  return { ...parameters, style: map };
}

async function resolved(engine: Engine, name: string, mapping: Mapping, recipe: string | undefined) {
  const source = await sourceOf(engine, name, recipe);
  const place = typeof source === 'string' ? '--style' : name;
  return at(
    place,
    resolveStyle(source, mapping, (mesh) => flowed(engine, mesh)),
  );
}

function isPicture(name: string): boolean {
  return /\.png$/i.test(name);
}

async function captureOf(name: string, recipe: string | undefined): Promise<GaussMap> {
  const bytes = await readBytes(pathOf(name, recipe));
  return at(
    name,
    Promise.resolve().then(() => mapOfPixels(readPng(bytes, name))),
  );
}

/** A name, or the mesh of a file: what has a folder or an ending and is no name. */
async function sourceOf(engine: Engine, name: string, recipe: string | undefined): Promise<StyleSource> {
  if (styleNames.includes(name) || !/[./\\]/.test(name)) return name;
  if (/\.(jpe?g|webp)$/i.test(name)) {
    throw new FileError(
      `${name}: a normal capture is a PNG; save the picture as one, or give a mesh or a name.`,
    );
  }
  const path = pathOf(name, recipe);
  const { mesh } = await at(name, engine.read(await readBytes(path), path));
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
