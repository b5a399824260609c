import type { WhittleError } from '../mesh/failure.ts';
import { decodeAscii, hasByteOrderMark, isTokenEnd, lineEndLength, tokenEnd } from './bytes.ts';
import { quote, refusal } from './refuse.ts';

const lf = 10;
const cr = 13;
const space = 32;
const hash = 35;
const backslash = 92;

/** Powers of ten that a double holds exactly. */
const exactPowers = Float64Array.from({ length: 23 }, (_, exponent) => Number(`1e${exponent}`));
/** Below this, ten times it plus a digit is at most 2^53. */
const largestMantissa = 900719925474098;
/** How programs spell what is not a number, or is infinite: "nan", "-nan(ind)", "1.#QNAN", "inf". */
const notFiniteWord = /^[+-]?(nan|inf|1\.#)/i;

/**
 * Walks over the bytes of a text file: blanks, numbers, lines. Readers and patchers use the same walk, so they cannot
 * disagree about where a number stands. A word that begins with `#` starts a comment, a `\` before a line end continues the line; LF, CR LF
 * and CR end lines. Lines are not counted on the way; {@link lineAt} counts them when an error needs it.
 */
export class TextScanner {
  readonly bytes: Uint8Array;
  readonly name: string;
  at: number;

  constructor(bytes: Uint8Array, name: string, at = 0) {
    this.bytes = bytes;
    this.name = name;
    this.at = at === 0 && hasByteOrderMark(bytes) ? 3 : at;
  }

  get done(): boolean {
    return this.at >= this.bytes.length;
  }

  /** Skips blanks within the line. The byte that follows, or LF at the end of line, file or at a comment. */
  peekInLine(): number {
    const bytes = this.bytes;
    const end = bytes.length;
    let at = this.at;
    while (at < end) {
      const c = bytes[at];
      if (c > space && c !== hash && c !== backslash) {
        this.at = at;
        return c;
      }
      if (c === lf || c === cr || c === hash) break;
      if (c !== backslash) {
        at++;
        continue;
      }
      const lineEnd = lineEndLength(bytes, at + 1);
      if (lineEnd === 0) {
        this.at = at;
        return c;
      }
      at += 1 + lineEnd;
    }
    this.at = at;
    return lf;
  }

  /** Skips blanks, line ends and comments. The byte that follows, or −1 at the end of the file. */
  peek(): number {
    for (;;) {
      const c = this.peekInLine();
      if (c !== lf) return c;
      if (this.done) return -1;
      this.nextLine();
    }
  }

  /** Moves to the beginning of the next line. */
  nextLine(): void {
    const bytes = this.bytes;
    const end = bytes.length;
    let at = this.at;
    while (at < end && bytes[at] !== lf && bytes[at] !== cr) at++;
    this.at = at < end ? at + lineEndLength(bytes, at) : end;
  }

  /** The number after the blanks of this line. @throws malformed-file, not-finite, truncated-file */
  numberInLine(what: string): number {
    this.peekInLine();
    return this.#number(what);
  }

  /** The next number, on this line or a later one. @throws malformed-file, not-finite, truncated-file */
  number(what: string): number {
    this.peek();
    return this.#number(what);
  }

  /** The number after the blanks of this line, NaN and infinite ones included. @throws malformed-file, truncated-file */
  anyNumberInLine(what: string): number {
    this.peekInLine();
    return this.#anyNumber(what);
  }

  /** The next number, on this line or a later one, NaN and infinite ones included. @throws malformed-file, truncated-file */
  anyNumber(what: string): number {
    this.peek();
    return this.#anyNumber(what);
  }

  /**
   * The decimal number at `at`, correctly rounded, or NaN (and `at` stays) if there is none. A mantissa of at most 2^53
   * times or over an exact power of ten needs one rounding only; everything else goes the slow way.
   */
  decimal(): number {
    const bytes = this.bytes;
    const start = this.at;
    let at = start;
    let c = bytes[at];
    const negative = c === 45;
    if (negative || c === 43) c = bytes[++at];
    const digits = at;
    let mantissa = 0;
    let exact = true;
    for (; c >= 48 && c <= 57; c = bytes[++at]) {
      if (mantissa > largestMantissa) exact = false;
      mantissa = mantissa * 10 + (c - 48);
    }
    let digitCount = at - digits;
    let scale = 0;
    if (c === 46) {
      const fraction = at + 1;
      for (c = bytes[++at]; c >= 48 && c <= 57; c = bytes[++at]) {
        if (mantissa > largestMantissa) exact = false;
        mantissa = mantissa * 10 + (c - 48);
      }
      scale = fraction - at;
      digitCount -= scale;
    }
    if (digitCount === 0) return Number.NaN;
    this.at = at;
    if (c === 101 || c === 69) scale += this.#exponent();
    if (!isTokenEnd(bytes, this.at)) {
      this.at = start;
      return Number.NaN;
    }
    if (!exact || scale > 22 || scale < -22) return Number(decodeAscii(bytes, start, this.at));
    const size = scale < 0 ? mantissa / exactPowers[-scale] : mantissa * exactPowers[scale];
    return negative ? -size : size;
  }

  /** The whole number at `at` (its end may be anything), or NaN. Saturates beyond ±2^31. */
  integer(): number {
    const bytes = this.bytes;
    let at = this.at;
    let c = bytes[at];
    const negative = c === 45;
    if (negative || c === 43) c = bytes[++at];
    if (!(c >= 48 && c <= 57)) return Number.NaN;
    let value = 0;
    for (; c >= 48 && c <= 57; c = bytes[++at]) if (value < 0x80000000) value = value * 10 + (c - 48);
    if (value > 0x80000000) value = 0x80000000;
    this.at = at;
    return negative ? -value : value;
  }

  /** Reads the word at `at` as text. */
  word(): string {
    const end = tokenEnd(this.bytes, this.at);
    const text = decodeAscii(this.bytes, this.at, end);
    this.at = end;
    return text;
  }

  skipWord(): void {
    this.at = tokenEnd(this.bytes, this.at);
  }

  /** Number of the line in which a byte stands, from 1. */
  lineAt(offset: number): number {
    let line = 1;
    for (let at = 0; at < offset && at < this.bytes.length; ) {
      const length = lineEndLength(this.bytes, at);
      if (length > 0 && at + length <= offset) line++;
      at += length || 1;
    }
    return line;
  }

  /** "line 812" for a byte offset. */
  placeAt(offset: number): string {
    return `line ${this.lineAt(offset)}`;
  }

  /** Why there is no number at `at`. */
  badNumber(what: string): WhittleError {
    const text = decodeAscii(this.bytes, this.at, tokenEnd(this.bytes, this.at));
    const place = this.placeAt(this.at);
    if (text === '') {
      return this.done
        ? refusal('truncated-file', this.name, place, `the file ends before ${what}; get it again in full.`)
        : refusal('malformed-file', this.name, place, `the line ends before ${what}; export it again.`);
    }
    if (notFiniteWord.test(text) || /^[+-]?[0-9.]+e\+?[0-9]+$/i.test(text)) {
      const sentence = `${what} is ${quote(text)}; replace it by a finite number.`;
      return refusal('not-finite', this.name, place, sentence);
    }
    const comma = /^[+-]?\d+,\d+$/.test(text);
    const advice = comma ? 'write decimals with a point' : 'export the file again';
    return refusal('malformed-file', this.name, place, `${what} is ${quote(text)}, not a number; ${advice}.`);
  }

  /** Why the three numbers behind a byte are no place: the first of them that is not finite. */
  badPosition(offset: number, of: string): WhittleError {
    this.at = offset;
    for (const axis of ['x', 'y', 'z']) {
      this.peek();
      const start = this.at;
      const value = this.decimal();
      if (value - value === 0) continue;
      this.at = start;
      return this.badNumber(`the ${axis} of ${of}`);
    }
    return this.badNumber(of);
  }

  #anyNumber(what: string): number {
    const value = this.decimal();
    if (!Number.isNaN(value)) return value;
    const { at } = this;
    if (notFiniteWord.test(this.word())) return value;
    this.at = at;
    throw this.badNumber(what);
  }

  #number(what: string): number {
    const start = this.at;
    const value = this.decimal();
    if (value - value === 0) return value;
    this.at = start;
    throw this.badNumber(what);
  }

  /** Reads `e±digits`; leaves `at` where it is if that is not what stands there. */
  #exponent(): number {
    const bytes = this.bytes;
    let at = this.at + 1;
    const negative = bytes[at] === 45;
    if (negative || bytes[at] === 43) at++;
    const digits = at;
    let exponent = 0;
    for (let c = bytes[at]; c >= 48 && c <= 57; c = bytes[++at]) {
      if (exponent < 10000) exponent = exponent * 10 + (c - 48);
    }
    if (at > digits) this.at = at;
    return negative ? -exponent : exponent;
  }
}
