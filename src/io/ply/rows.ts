import { viewOf } from '../bytes.ts';
import { TextScanner } from '../text-scanner.ts';
import { kindSize, type PlyProperty } from './header.ts';
import { getNumber } from './source.ts';

/** Finds the properties of a vertex in its row: a list before them moves them, by another length in each row. */
export class PlyRows {
  readonly #properties: readonly PlyProperty[];
  readonly #columns: readonly number[];
  readonly #hasLists: boolean;
  /** Where the columns are, of the row before. */
  readonly #places: number[] = [];
  /** Bytes from the beginning of each row to the columns, where there are no lists. */
  readonly #fixed: readonly number[];

  /** @param columns indices of the properties that are asked for, rising */
  constructor(properties: readonly PlyProperty[], columns: readonly number[]) {
    this.#properties = properties.slice(0, columns.at(-1)! + 1);
    this.#columns = columns;
    this.#hasLists = this.#properties.some(({ countKind }) => countKind !== undefined);
    this.#fixed = [...this.#walk(0, (at, { kind }) => at + kindSize[kind])];
  }

  /** Byte offsets of the columns in the row of a binary file that begins at `offset`. The result is used again. */
  bytes(source: Uint8Array, offset: number, little: boolean): readonly number[] {
    if (this.#hasLists) {
      const view = viewOf(source);
      return this.#walk(offset, (at, { kind, countKind }) => {
        if (!countKind) return at + kindSize[kind];
        return at + kindSize[countKind] + getNumber(view, at, countKind, little) * kindSize[kind];
      });
    }
    for (let i = 0; i < this.#fixed.length; i++) this.#places[i] = offset + this.#fixed[i];
    return this.#places;
  }

  /** Which words of the row of a text file that begins at `offset` the columns are. The result is used again. */
  words(source: Uint8Array, offset: number): readonly number[] {
    if (!this.#hasLists) return this.#columns;
    const scanner = new TextScanner(source, '', offset);
    return this.#walk(0, (word, { countKind }) => {
      const more = countKind ? scanner.number('the length of a list') : 0;
      for (let i = countKind ? 0 : -1; i < more; i++) {
        scanner.peek();
        scanner.skipWord();
      }
      return word + 1 + more;
    });
  }

  /** @param next the place behind a property that stands at a place */
  #walk(from: number, next: (at: number, property: PlyProperty) => number): readonly number[] {
    let at = from;
    let found = 0;
    this.#properties.forEach((property, i) => {
      if (i === this.#columns[found]) this.#places[found++] = at;
      at = next(at, property);
    });
    return this.#places;
  }
}
