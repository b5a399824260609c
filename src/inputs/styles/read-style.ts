import { at, WhittleError } from '../../mesh/failure.ts';
import type { Mesh } from '../../mesh/mesh.ts';
import type { GaussMap } from '../../methods/values/gauss-map.ts';
import { checkValue } from '../../methods/values/index.ts';
import { parseJson } from '../../methods/values/json.ts';
import type { Directions } from '../../methods/values/points.ts';
import type { StyleParameter } from '../../methods/values/style.ts';
import { mapOfCapture } from './exact-capture.ts';
import { type Flow, type Mapping, resolveStyle, type StyleSource, styleNames } from './resolve.ts';

/** What it takes to read a style that is a file. */
export interface StyleReading {
  /** The bytes of a file that a recipe names. @throws Error whose sentence begins with the name */
  readonly readFile: (name: string) => Promise<Uint8Array<ArrayBuffer>>;
  /** @throws WhittleError */
  readonly readMesh: (bytes: Uint8Array<ArrayBuffer>, name: string) => Promise<Mesh>;
  readonly flow: Flow;
}

/** What a recipe says of a style. */
export interface StyleReference {
  /** A name of ours, the name of a file, or directions. */
  readonly given: string | Directions;
  readonly mapping: Mapping;
}

/**
 * Makes the Gauss map of what a recipe calls a style: one of ours by its name, or by a file's name a mesh, a PNG that holds a
 * normal capture, or a JSON list of directions.
 *
 * @throws WhittleError as `resolveStyle` and the readers, the sentence beginning with the file or the parameter
 */
export async function readStyle(
  parameter: StyleParameter,
  { given, mapping }: StyleReference,
  reading: StyleReading,
): Promise<GaussMap> {
  if (isCapture(given) && parameter.mapping === undefined) {
    const bytes = await reading.readFile(given);
    return at(given, () => mapOfCapture(bytes, given));
  }
  const source = await sourceOf(given, parameter, reading);
  const place = typeof given === 'string' && typeof source !== 'string' ? given : `“${parameter.name}”`;
  return at(place, () => resolveStyle(source, mapping, reading.flow));
}

function isCapture(given: string | Directions): given is string {
  return typeof given === 'string' && /\.png$/i.test(given);
}

/** A list, a name, or what a file holds: what has a folder or an ending and is no name of ours is a file. */
async function sourceOf(
  given: string | Directions,
  parameter: StyleParameter,
  { readFile, readMesh }: StyleReading,
): Promise<StyleSource> {
  if (typeof given !== 'string' || styleNames.includes(given) || !/[./\\]/.test(given)) return given;
  if (/\.(jpe?g|webp)$/i.test(given)) {
    throw new WhittleError(
      'unsupported-file',
      `${given}: a normal capture is a PNG; save the picture as one, or give a mesh or a name.`,
    );
  }
  const bytes = await readFile(given);
  if (/\.json$/i.test(given)) return directionsOf(bytes, given, parameter);
  return at(given, readMesh(bytes, given));
}

function directionsOf(bytes: Uint8Array, file: string, parameter: StyleParameter): Directions {
  const listed = parseJson(new TextDecoder().decode(bytes), file);
  const problem = checkValue(parameter, listed);
  if (problem) throw new WhittleError(problem.code, `${file}: ${problem.message}`);
  return listed as Directions;
}
