import { ByteWriter } from './byte-writer.ts';
import { tokenEnd } from './bytes.ts';
import { TextScanner } from './text-scanner.ts';

/** Replaces single numbers of a text file; every other byte is copied. Rows must come in the order of the file. */
export class TextPatch {
  readonly #scanner: TextScanner;
  readonly #writer: ByteWriter;
  #copied = 0;

  constructor(source: Uint8Array) {
    this.#scanner = new TextScanner(source, '');
    this.#writer = new ByteWriter(source.length + (source.length >> 2));
  }

  /**
   * Rewrites numbers of the row that begins at byte `offset`.
   *
   * @param columns which numbers of the row, ascending, from 0
   * @param texts the new text of each, or undefined to keep what is there
   */
  row(offset: number, columns: readonly number[], texts: readonly (string | undefined)[]): void {
    const scanner = this.#scanner;
    const { bytes } = scanner;
    scanner.at = offset;
    let column = 0;
    for (let i = 0; i < columns.length; i++) {
      for (; column < columns[i]; column++) {
        scanner.peek();
        scanner.skipWord();
      }
      const text = texts[i];
      if (text === undefined) continue;
      scanner.peek();
      this.#writer.copy(bytes, this.#copied, scanner.at);
      this.#writer.ascii(text);
      this.#copied = scanner.at = tokenEnd(bytes, scanner.at);
      column++;
    }
  }

  take(): Uint8Array<ArrayBuffer> {
    const { bytes } = this.#scanner;
    this.#writer.copy(bytes, this.#copied, bytes.length);
    this.#copied = bytes.length;
    return this.#writer.take();
  }
}

export const firstThree: readonly number[] = [0, 1, 2];

/** New texts for a position, undefined where the coordinate is what it was. The shortest text that reads back exactly. */
export function positionTexts(before: Float64Array, after: Float64Array, p: number): (string | undefined)[] {
  const texts: (string | undefined)[] = [undefined, undefined, undefined];
  for (let axis = 0; axis < 3; axis++) {
    const value = after[3 * p + axis];
    if (value !== before[3 * p + axis]) texts[axis] = String(value);
  }
  return texts;
}

/**
 * New texts for a unit normal (six decimals, as files have them), undefined where it keeps its own: normals that are
 * NaN, and numbers that do not differ in six decimals.
 */
export function normalTexts(stored: Float64Array, normals: Float64Array, n: number): (string | undefined)[] {
  const texts: (string | undefined)[] = [undefined, undefined, undefined];
  for (let axis = 0; axis < 3; axis++) {
    const value = normals[3 * n + axis];
    const kept = stored[3 * n + axis];
    if (!Number.isNaN(value) && !(Math.abs(value - kept) < 1e-6)) {
      texts[axis] = String(Math.round(value * 1e6) / 1e6 + 0);
    }
  }
  return texts;
}

/** Whether a position is anywhere else than before. */
export function hasMoved(before: Float64Array, after: Float64Array, p: number): boolean {
  const i = 3 * p;
  return before[i] !== after[i] || before[i + 1] !== after[i + 1] || before[i + 2] !== after[i + 2];
}
