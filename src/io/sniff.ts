import { hasModel } from './3mf/scan.ts';
import { decodeAscii, hasByteOrderMark } from './bytes.ts';
import type { Format } from './formats.ts';
import { fileNameEndings } from './formats.ts';
import { isBareOff, offKeyword } from './off/header.ts';
import { readPlyHeader } from './ply/header.ts';
import { refusal } from './refuse.ts';
import { hasFacetLength, looksLikeFacets } from './stl/facet-count.ts';
import { TextScanner } from './text-scanner.ts';
import { isZip } from './zip.ts';

/** Files that people drop by mistake, by their first bytes: what they are and what to do. */
const strangers: readonly (readonly [readonly number[], string])[] = [
  [[0x1f, 0x8b], 'it is compressed with gzip; unpack it first'],
  [[0x42, 0x5a, 0x68], 'it is compressed with bzip2; unpack it first'],
  [[0xfd, 0x37, 0x7a, 0x58, 0x5a], 'it is compressed with xz; unpack it first'],
  [[0x37, 0x7a, 0xbc, 0xaf], 'it is a 7z archive; unpack it first'],
  [[0x28, 0xb5, 0x2f, 0xfd], 'it is compressed with zstd; unpack it first'],
  [[0xff, 0xfe], 'its text is in UTF-16; save it as UTF-8'],
  [[0xfe, 0xff], 'its text is in UTF-16; save it as UTF-8'],
  [[...'Kaydara FBX'].map((letter) => letter.charCodeAt(0)), 'it is an FBX file; export it as .glb or .obj'],
  [[...'BLENDER'].map((letter) => letter.charCodeAt(0)), 'it is a Blender file; export it as .glb or .obj'],
  [[...'DRACO'].map((letter) => letter.charCodeAt(0)), 'it is a Draco file; export it as .ply or .obj'],
  [[0x89, 0x50, 0x4e, 0x47], 'it is a picture; open a mesh instead'],
  [[0xff, 0xd8, 0xff], 'it is a picture; open a mesh instead'],
  [[0x25, 0x50, 0x44, 0x46], 'it is a PDF; open a mesh instead'],
];

/** How many bytes decide whether a file is text. */
const probe = 1024;

/**
 * Recognises a file by its bytes; the name does not count.
 *
 * @throws empty-file, unknown-format, unsupported-file (compressed, UTF-16, another 3D format), and what a PLY header
 *   throws
 */
export function recognise(bytes: Uint8Array, name: string): Format {
  if (bytes.length === 0) throw refusal('empty-file', name, '', 'it is empty; export it again.');
  const stranger = strangers.find(([magic]) => magic.every((byte, i) => bytes[i] === byte));
  if (stranger) throw refusal('unsupported-file', name, '', `${stranger[1]}.`);
  if (isZip(bytes)) {
    if (hasModel(bytes, name)) return '3mf';
    throw refusal('unsupported-file', name, '', 'it is a zip archive; unpack it first.');
  }
  if (decodeAscii(bytes, 0, 4) === 'glTF') return 'glb';
  const begin = hasByteOrderMark(bytes) ? 3 : 0;
  if (/^ply\s/i.test(decodeAscii(bytes, begin, begin + 4))) {
    return readPlyHeader(bytes, name).encoding === 'ascii' ? 'ply-ascii' : 'ply-binary';
  }
  // Before text: a binary STL may begin with "solid", but no text happens to have its exact length.
  if (hasFacetLength(bytes)) return 'stl-binary';
  if (isText(bytes)) return recogniseText(bytes, name);
  if (looksLikeUtf16(bytes)) {
    throw refusal('unsupported-file', name, '', 'its text is in UTF-16; save it as UTF-8.');
  }
  if (looksLikeFacets(bytes)) return 'stl-binary';
  throw unknown(name, 'it is no mesh file that is known here');
}

function recogniseText(bytes: Uint8Array, name: string): Format {
  const scanner = new TextScanner(bytes, name);
  const first = scanner.peek();
  if (first < 0) {
    const hasComment = bytes.includes(35);
    throw refusal(
      'empty-file',
      name,
      '',
      `it has no content${hasComment ? ' but comments' : ''}; export it again.`,
    );
  }
  if (first === 123) return 'gltf';
  if (first === 60) {
    throw unknown(name, 'it is a web page or XML, not a mesh; the download probably failed, get it again');
  }
  const start = scanner.at;
  const word = scanner.word();
  if (/^(solid|facet$)/i.test(word)) return 'stl-ascii';
  if (offKeyword(word)) return 'off';
  scanner.at = start;
  if (hasObjStatement(scanner)) return 'obj';
  if (isBareOff(bytes)) return 'off';
  throw unknown(name, 'it is text, but no mesh file that is known here');
}

/** A vertex or a face somewhere. Comments and statements of other kinds may come first, for as long as they like. */
function hasObjStatement(scanner: TextScanner): boolean {
  const { bytes } = scanner;
  for (; !scanner.done; scanner.nextLine()) {
    const c = scanner.peekInLine();
    if (c !== 118 && c !== 102) continue;
    const next = bytes[scanner.at + 1];
    if (next === 32 || next === 9) return true;
  }
  return false;
}

function unknown(name: string, why: string): Error {
  return refusal('unknown-format', name, '', `${why}. Use one of ${fileNameEndings.join(', ')}.`);
}

/**
 * Whether the beginning is text: next to no control characters. Zeros in comments do not count (some programs write their name
 * there from a buffer of fixed length), nor those at the end of the file.
 */
function isText(bytes: Uint8Array): boolean {
  let end = bytes.length;
  while (end > 0 && bytes[end - 1] === 0) end--;
  end = Math.min(probe, end);
  let strange = 0;
  let inComment = false;
  for (let at = 0; at < end; at++) {
    const c = bytes[at];
    if (c === 10 || c === 13) inComment = false;
    else if (c === 35) inComment ||= at === 0 || bytes[at - 1] <= 32;
    else if (c === 0 ? !inComment : c < 9 || (c > 13 && c < 32 && c !== 26 && c !== 27)) strange++;
  }
  return strange <= end / 64;
}

/** Every other byte is zero. */
function looksLikeUtf16(bytes: Uint8Array): boolean {
  const length = Math.min(probe, bytes.length) & ~1;
  if (length < 8) return false;
  const zeros = [0, 0];
  for (let at = 0; at < length; at++) if (bytes[at] === 0) zeros[at & 1]++;
  return Math.max(...zeros) > 0.45 * length && Math.min(...zeros) < 0.05 * length;
}
