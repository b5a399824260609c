import { WhittleError } from '../mesh/failure.ts';

/** Every kind of file that can be read and written, by its bytes. `ply-binary` covers both byte orders. */
export const formats = [
  'obj',
  'stl-binary',
  'stl-ascii',
  'ply-ascii',
  'ply-binary',
  'off',
  'glb',
  'gltf',
] as const;

export type Format = (typeof formats)[number];

/** The formats that go with each ending; the first is what a new file gets. */
const formatsOfEnding: Readonly<Record<string, readonly [Format, ...Format[]]>> = {
  '.obj': ['obj'],
  '.stl': ['stl-binary', 'stl-ascii'],
  '.ply': ['ply-binary', 'ply-ascii'],
  '.off': ['off'],
  '.glb': ['glb'],
  '.gltf': ['gltf'],
};

/** File name endings that can be read and written, with their dots. */
export const fileNameEndings: readonly string[] = Object.keys(formatsOfEnding);

/**
 * The format in which to write a file of this name.
 *
 * @param source the format of the file that is being given back; it is kept where it goes with the ending, so that an
 *   ASCII STL stays one
 * @throws unknown-format if the ending is none of {@link fileNameEndings}
 */
export function formatForFileName(name: string, source?: Format): Format {
  const dot = name.lastIndexOf('.');
  const ending = dot < 0 ? '' : name.slice(dot).toLowerCase();
  const candidates = Object.hasOwn(formatsOfEnding, ending) ? formatsOfEnding[ending] : undefined;
  if (!candidates) {
    const list = fileNameEndings.join(', ');
    throw new WhittleError('unknown-format', `${name}: the file name must end in one of ${list}.`);
  }
  return source !== undefined && candidates.includes(source) ? source : candidates[0];
}

export function isFormat(text: string): text is Format {
  return (formats as readonly string[]).includes(text);
}
