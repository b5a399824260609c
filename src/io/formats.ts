import { WhittleError } from '../mesh/failure.ts';

/**
 * Every kind of file that can be read and written, by its bytes: the one list of them. Of several formats with one ending the
 * first is what a new file gets. Printers' files have z up, nearly all else has y up. `ply-binary` covers both byte orders.
 */
export const formats = [
  { id: 'obj', ending: '.obj', label: 'OBJ', up: 'y' },
  { id: 'glb', ending: '.glb', label: 'glTF binary (GLB)', up: 'y' },
  { id: 'gltf', ending: '.gltf', label: 'glTF (text)', up: 'y' },
  { id: 'stl-binary', ending: '.stl', label: 'STL for printing', up: 'z' },
  { id: 'stl-ascii', ending: '.stl', label: 'STL (text)', up: 'z' },
  { id: 'ply-binary', ending: '.ply', label: 'PLY', up: 'y' },
  { id: 'ply-ascii', ending: '.ply', label: 'PLY (text)', up: 'y' },
  { id: '3mf', ending: '.3mf', label: '3MF for printing', up: 'z' },
  { id: 'off', ending: '.off', label: 'OFF', up: 'y' },
] as const;

/** A format by its name. */
export type Format = (typeof formats)[number]['id'];

export interface FormatInfo {
  readonly id: Format;
  /** What file names end in, with its dot. */
  readonly ending: string;
  /** What a person reads in a menu. */
  readonly label: string;
  /** The axis that points up in such files. */
  readonly up: 'y' | 'z';
}

/** File name endings that can be read and written, with their dots. */
export const fileNameEndings: readonly string[] = [...new Set(formats.map(({ ending }) => ending))];

/** The file name's ending in small letters, with its dot; '' if it has none. */
export function endingOf(name: string): string {
  return /\.[^./\\]*$/.exec(name)?.[0].toLowerCase() ?? '';
}

/** True for the name of a mesh file that can be read, as far as a name can tell. */
export function isMeshFileName(name: string): boolean {
  return fileNameEndings.includes(endingOf(name));
}

export function isFormat(text: string): text is Format {
  return formats.some(({ id }) => id === text);
}

export function formatInfo(format: Format): FormatInfo {
  return formats.find(({ id }) => id === format)!;
}

/**
 * The format in which to write a file of this name.
 *
 * @param source the format of the file that is being given back; it is kept where it goes with the ending, so that an
 *   ASCII STL stays one
 * @throws unknown-format if the ending is that of none of {@link formats}
 */
export function formatForFileName(name: string, source?: Format): Format {
  const candidates = formats.filter(({ ending }) => ending === endingOf(name));
  if (candidates.length === 0) {
    const list = fileNameEndings.join(', ');
    throw new WhittleError('unknown-format', `${name}: the file name must end in one of ${list}.`);
  }
  return (candidates.find(({ id }) => id === source) ?? candidates[0]!).id;
}
