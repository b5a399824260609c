import type { Engine } from '../engine/client.ts';
import { pngOfSphereField, readSphereField } from '../inputs/fields/read-sphere-field.ts';
import { isSphereMap, type SphereMap } from '../inputs/styles/captures.ts';
import { captureFile } from '../inputs/styles/exact-capture.ts';
import { readStyle } from '../inputs/styles/read-style.ts';
import { at, WhittleError } from '../mesh/failure.ts';
import { findMethod } from '../methods/registry.ts';
import type { ParameterValue, ParameterValues } from '../methods/values/index.ts';
import type { SphereFieldParameter } from '../methods/values/sphere-field.ts';
import type { StyleParameter } from '../methods/values/style.ts';
import type { RecipeStep } from './recipe.ts';
import type { Asset, Surroundings } from './resolve.ts';

/** A file that a step names. */
export interface NamedFile {
  readonly name: string;
  /** The parameter that takes a style or a field over the sphere from it; absent where it is an image. */
  readonly parameter?: StyleParameter | SphereFieldParameter;
}

/** The files that steps name, each once. What has a folder or an ending is a file; names of ours have neither. */
export function filesNamedBy(steps: readonly RecipeStep[]): readonly NamedFile[] {
  const found = new Map<string, NamedFile>();
  for (const { method, parameters } of steps)
    for (const descriptor of findMethod(method)?.parameters ?? []) {
      const name = parameters[descriptor.name];
      if (!namesFile(name) || found.has(name)) continue;
      const isOwn = descriptor.kind === 'style' || descriptor.kind === 'sphereField';
      found.set(name, isOwn ? { name, parameter: descriptor } : { name });
    }
  return [...found.values()];
}

/** The step with other names for the files that it names. */
export function withFileNames(step: RecipeStep, renamed: (name: string) => string): RecipeStep {
  const entries = Object.entries(step.parameters).map(([key, value]) => [
    key,
    namesFile(value) ? renamed(value) : value,
  ]);
  return { ...step, parameters: Object.fromEntries(entries) as ParameterValues };
}

function namesFile(value: ParameterValue | undefined): value is string {
  return typeof value === 'string' && /[./\\]/.test(value);
}

/**
 * Reads a file that a recipe names, as the command line would.
 *
 * @throws WhittleError as the readers, the sentence beginning with the name
 */
export async function readAsset(
  { name, parameter }: NamedFile,
  file: Uint8Array<ArrayBuffer>,
  engine: Engine,
  decodeImage: NonNullable<Surroundings['decodeImage']>,
): Promise<Asset> {
  const readFile = async () => file;
  if (parameter?.kind === 'sphereField')
    return { kind: 'sphere-field', field: await readSphereField(name, { readFile, decodeImage }), file };
  if (!parameter) return { kind: 'image', image: await at(name, decodeImage(file, name)), file };
  const readMesh = async () => (await at(name, engine.read(file, name))).mesh;
  if (!/\.(png|json)$/i.test(name)) return { kind: 'mesh', mesh: await readMesh(), file };
  const reading = { readFile, readMesh, flow: noFlow };
  const map = await readStyle(parameter, { given: name, mapping: 'auto' }, reading);
  return { kind: 'gauss-map', map, file };
}

/** Neither captures nor lists of directions are read through the sphere. */
async function noFlow(): Promise<never> {
  throw new WhittleError('internal', 'Only meshes flow to the sphere.');
}

const drawn = new WeakMap<Asset, Uint8Array<ArrayBuffer>>();

/** The file of an asset, from which {@link readAsset} gets the same again. @throws WhittleError where it has none */
export function fileOfAsset(asset: Asset, name: string): Uint8Array<ArrayBuffer> {
  const known = asset.file ?? drawn.get(asset);
  if (known) return known;
  const isPainted = asset.kind === 'sphere-field' || (asset.kind === 'gauss-map' && isSphereMap(asset.map));
  if (!isPainted)
    throw new WhittleError('internal', `${name}: the file that it was read from is gone; bring it again.`);
  const file =
    asset.kind === 'sphere-field' ? pngOfSphereField(asset.field) : captureFile(asset.map as SphereMap);
  drawn.set(asset, file);
  return file;
}
