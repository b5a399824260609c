import { decodeAscii, hasByteOrderMark, lineEndLength } from '../bytes.ts';
import { counted, quote, refusal } from '../refuse.ts';

/** Kinds of number, each under its two names. */
const kinds = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
} as const;

export type NumberKind = (typeof kinds)[keyof typeof kinds];

export const kindSize: Readonly<Record<NumberKind, number>> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

export interface PlyProperty {
  readonly name: string;
  /** How the value, or each entry of a list, is stored. */
  readonly kind: NumberKind;
  /** How the length of the list is stored, if it is one. */
  readonly countKind?: NumberKind;
  /** Bytes [begin, end) of the word that says `kind`; of a list, of the word `list`. */
  readonly kindSpan: readonly [number, number];
}

export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: PlyProperty[];
}

export interface PlyHeader {
  readonly encoding: 'ascii' | 'little' | 'big';
  readonly elements: readonly PlyElement[];
  /** Byte at which the data begins. */
  readonly bodyStart: number;
  /** A sentence about lines that were skipped. */
  readonly warnings: readonly string[];
}

const encodings: Readonly<Record<string, PlyHeader['encoding']>> = {
  ascii: 'ascii',
  binary_little_endian: 'little',
  binary_big_endian: 'big',
};

/** No header needs more lines than this. */
const mostLines = 10000;

/**
 * Reads the header. Lines that say nothing about the data (old exporters forget the word `comment`) are skipped.
 *
 * @throws malformed-file, truncated-file
 */
export function readPlyHeader(bytes: Uint8Array, name: string): PlyHeader {
  const elements: PlyElement[] = [];
  const strays: string[] = [];
  let encoding: PlyHeader['encoding'] | undefined;
  let at = hasByteOrderMark(bytes) ? 3 : 0;
  for (let line = 1; line <= mostLines; line++) {
    const end = lineEnd(bytes, at);
    if (end >= bytes.length) break;
    const words = decodeAscii(bytes, at, end).trim().split(/\s+/, 6);
    const fail = (what: string) =>
      refusal('malformed-file', name, `line ${line}`, `${what}; export the file again.`);
    const begin = at;
    at = end + lineEndLength(bytes, end);
    if (words[0] === 'format') {
      encoding = Object.hasOwn(encodings, words[1]) ? encodings[words[1]] : undefined;
      if (!encoding) throw fail(`${quote(words[1] ?? '')} is not a PLY format`);
    } else if (words[0] === 'element') {
      elements.push(element(words, fail));
    } else if (words[0] === 'property') {
      const owner = elements.at(-1);
      if (!owner) throw fail('a property stands before the first element');
      owner.properties.push({ ...property(words, fail), kindSpan: secondWord(bytes, begin, end) });
    } else if (words[0] === 'end_header') {
      if (!encoding) throw fail('the header names no format');
      return { encoding, elements, bodyStart: at, warnings: skippedLines(strays) };
    } else if (!['ply', 'comment', 'obj_info', ''].includes(words[0].toLowerCase())) {
      if (isSpoiled(words)) throw fail(`${quote(words[0])} does not belong in a PLY header`);
      strays.push(words[0]);
    }
  }
  throw refusal(
    'truncated-file',
    name,
    '',
    'the PLY header has no end_header; the file was cut off. Get it again.',
  );
}

/** Whether a line has the form of an element or a property: to skip it would be to misread the data. */
function isSpoiled(words: readonly string[]): boolean {
  const [, second = '', third = ''] = words;
  const isProperty = second === 'list' || isNumberKind(second);
  return isProperty || (words.length === 3 && /^\d+$/.test(third));
}

function skippedLines(strays: readonly string[]): string[] {
  if (strays.length === 0) return [];
  const what = counted(strays.length, 'line');
  return [`Skipped ${what} of the PLY header that say nothing of the data (the first: ${quote(strays[0])}).`];
}

function lineEnd(bytes: Uint8Array, from: number): number {
  let at = from;
  while (at < bytes.length && bytes[at] !== 10 && bytes[at] !== 13) at++;
  return at;
}

/** Where the second word of a line stands. */
function secondWord(bytes: Uint8Array, begin: number, end: number): [number, number] {
  const [, before, word] = /^(\s*\S+\s+)(\S+)/.exec(decodeAscii(bytes, begin, end))!;
  const at = begin + before.length;
  return [at, at + word.length];
}

function element(words: readonly string[], fail: (what: string) => Error): PlyElement {
  const count = /^\d+$/.test(words[2] ?? '') ? Number(words[2]) : Number.NaN;
  if (!Number.isSafeInteger(count)) {
    throw fail(`element ${quote(words[1] ?? '')} has the count ${quote(words[2] ?? '')}`);
  }
  return { name: words[1], count, properties: [] };
}

function property(words: readonly string[], fail: (what: string) => Error): Omit<PlyProperty, 'kindSpan'> {
  if (words[1] !== 'list') return { name: words[2] ?? '', kind: numberKind(words[1], fail) };
  const countKind = numberKind(words[2], fail);
  return { name: words[4] ?? '', kind: numberKind(words[3], fail), countKind };
}

function numberKind(word: string | undefined, fail: (what: string) => Error): NumberKind {
  if (word === undefined || !isNumberKind(word)) throw fail(`${quote(word ?? '')} is not a PLY number type`);
  return Object.hasOwn(kinds, word) ? kinds[word as keyof typeof kinds] : (word as NumberKind);
}

function isNumberKind(word: string): boolean {
  return Object.hasOwn(kinds, word) || Object.values(kinds).some((kind) => kind === word);
}
