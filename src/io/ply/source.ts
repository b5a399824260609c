import { viewOf } from '../bytes.ts';
import { refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';
import { kindSize, type NumberKind } from './header.ts';

/** Where the values of a PLY body come from, one after the other; text and binary alike. */
export interface PlySource {
  /** Byte offset of the next value (in text: of its row, or blanks before it). */
  readonly at: number;
  /** The next value; may be NaN or infinite. @throws truncated-file, and in text what a scanner throws */
  next(kind: NumberKind, what: string): number;
  skip(kind: NumberKind, count: number): void;
  /** Fewest bytes that `count` values take. */
  leastBytes(kind: NumberKind, count: number): number;
  readonly bytesLeft: number;
  /** "line 12", or "byte 1024". */
  place(offset: number): string;
}

export class PlyText implements PlySource {
  readonly #scanner: TextScanner;

  constructor(bytes: Uint8Array, name: string, bodyStart: number) {
    this.#scanner = new TextScanner(bytes, name, bodyStart);
  }

  get at(): number {
    this.#scanner.peek();
    return this.#scanner.at;
  }

  get bytesLeft(): number {
    return this.#scanner.bytes.length - this.#scanner.at;
  }

  next(_kind: NumberKind, what: string): number {
    return this.#scanner.anyNumber(what);
  }

  skip(_kind: NumberKind, count: number): void {
    for (let i = 0; i < count; i++) {
      if (this.#scanner.peek() < 0) throw this.#scanner.badNumber('the last element');
      this.#scanner.skipWord();
    }
  }

  /** A digit and a blank each, but none behind the last one of the file. */
  leastBytes(_kind: NumberKind, count: number): number {
    return Math.max(0, 2 * count - 1);
  }

  place(offset: number): string {
    return this.#scanner.placeAt(offset);
  }
}

export class PlyBinary implements PlySource {
  at: number;
  readonly #view: DataView;
  readonly #little: boolean;
  readonly #name: string;

  constructor(bytes: Uint8Array, name: string, bodyStart: number, little: boolean) {
    this.#view = viewOf(bytes);
    this.#little = little;
    this.#name = name;
    this.at = bodyStart;
  }

  get bytesLeft(): number {
    return this.#view.byteLength - this.at;
  }

  next(kind: NumberKind, what: string): number {
    const { at } = this;
    this.at += kindSize[kind];
    if (this.at > this.#view.byteLength) throw this.#cutOff(what);
    return getNumber(this.#view, at, kind, this.#little);
  }

  skip(kind: NumberKind, count: number): void {
    this.at += kindSize[kind] * count;
    if (this.at > this.#view.byteLength) throw this.#cutOff('the last element');
  }

  leastBytes(kind: NumberKind, count: number): number {
    return kindSize[kind] * count;
  }

  place(offset: number): string {
    return `byte ${offset}`;
  }

  #cutOff(what: string): Error {
    const place = `byte ${this.#view.byteLength}`;
    return refusal(
      'truncated-file',
      this.#name,
      place,
      `the file ends before ${what}; get it again in full.`,
    );
  }
}

/** A number of a binary file. */
export function getNumber(view: DataView, at: number, kind: NumberKind, little: boolean): number {
  switch (kind) {
    case 'float32':
      return view.getFloat32(at, little);
    case 'float64':
      return view.getFloat64(at, little);
    case 'uint8':
      return view.getUint8(at);
    case 'int8':
      return view.getInt8(at);
    case 'uint16':
      return view.getUint16(at, little);
    case 'int16':
      return view.getInt16(at, little);
    case 'uint32':
      return view.getUint32(at, little);
    case 'int32':
      return view.getInt32(at, little);
  }
}
