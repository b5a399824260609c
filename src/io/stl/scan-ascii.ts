import { FaceCollector } from '../faces.ts';
import { FloatList, IndexList } from '../lists.ts';
import type { ParsedFile } from '../parsed-file.ts';
import { quote, refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';

/** An ASCII STL and where its numbers stand. Positions are not shared: each corner has its own. */
export interface StlTextFile extends ParsedFile {
  /** #F×3 as the file has them; NaN where it has no number. */
  readonly facetNormals: Float64Array;
  /** #F byte offsets just behind each `normal`. */
  readonly normalOffsets: Uint32Array;
  /** #P byte offsets just behind each `vertex`. */
  readonly positionOffsets: Uint32Array;
}

const lf = 10;

/**
 * Reads ASCII STL, one solid or several.
 *
 * @throws no-faces, malformed-file, truncated-file, not-finite
 */
export function scanStlText(bytes: Uint8Array, name: string): StlTextFile {
  return new StlTextScan(bytes, name).run();
}

class StlTextScan {
  readonly #scanner: TextScanner;
  readonly #positions = new FloatList();
  readonly #positionOffsets = new IndexList();
  readonly #normals = new FloatList();
  readonly #normalOffsets = new IndexList();
  readonly #faces = new FaceCollector();
  #insideFacet = false;
  #insideSolid = false;

  constructor(bytes: Uint8Array, name: string) {
    this.#scanner = new TextScanner(bytes, name);
  }

  run(): StlTextFile {
    const scanner = this.#scanner;
    while (scanner.peek() >= 0) this.#statement();
    if (this.#insideFacet) {
      const sentence = 'the file ends in the middle of a facet; it was cut off. Export it again.';
      throw refusal('truncated-file', scanner.name, scanner.placeAt(scanner.at), sentence);
    }
    const describe = (offset: number) => scanner.placeAt(offset);
    const positions = this.#positions.take();
    const warnings = this.#faces.warnings(describe);
    const faces = this.#faces.finish(scanner.name, positions.length / 3, describe, 0);
    if (this.#insideSolid)
      warnings.push('There is no "endsolid" at the end; the file may have been cut off.');
    return {
      positions,
      faces,
      warnings,
      facetNormals: this.#normals.take(),
      normalOffsets: this.#normalOffsets.take(),
      positionOffsets: this.#positionOffsets.take(),
    };
  }

  #statement(): void {
    const scanner = this.#scanner;
    const start = scanner.at;
    const word = this.#keyword();
    if (word === 'vertex') this.#vertex();
    else if (word === 'facet') this.#facet(start);
    else if (word === 'endfacet') this.#endFacet(start);
    else if (word === 'solid' || word === 'endsolid') {
      this.#insideSolid = word === 'solid';
      scanner.nextLine();
    } else if (word !== 'outer' && word !== 'loop' && word !== 'endloop' && word !== 'outerloop') {
      scanner.at = start;
      throw this.#malformed(start, `there is ${quote(scanner.word())} where STL has a facet or a vertex`);
    }
  }

  /** The next word in small letters; an `end` that stands apart from what it ends is put before it. */
  #keyword(): string {
    const scanner = this.#scanner;
    let word = scanner.word().toLowerCase();
    if (word === 'vertex') return word; // most of them are
    if (word === 'end' && scanner.peekInLine() !== lf) word += scanner.word().toLowerCase();
    // A name may be glued to it, as in "solid_1".
    if (word.startsWith('solid')) return 'solid';
    return word.startsWith('endsolid') ? 'endsolid' : word;
  }

  #facet(start: number): void {
    if (this.#insideFacet) throw this.#malformed(start, 'a facet begins inside another one');
    this.#insideFacet = true;
    const scanner = this.#scanner;
    scanner.peek();
    const normalStart = scanner.at;
    if (scanner.word().toLowerCase() !== 'normal')
      throw this.#malformed(normalStart, 'a facet has no normal');
    this.#normalOffsets.push(scanner.at);
    for (let axis = 0; axis < 3; axis++) {
      // Exporters write "nan" for slivers; the normal is not used, only rewritten.
      scanner.peek();
      const value = scanner.decimal();
      if (Number.isNaN(value)) scanner.skipWord();
      this.#normals.push(value);
    }
  }

  #vertex(): void {
    const scanner = this.#scanner;
    if (!this.#insideFacet) throw this.#malformed(scanner.at, 'a vertex stands outside of a facet');
    this.#positionOffsets.push(scanner.at);
    this.#faces.corner(this.#positions.length / 3);
    const x = scanner.number('the x of the vertex');
    const y = scanner.number('the y of the vertex');
    this.#positions.push3(x, y, scanner.number('the z of the vertex'));
  }

  #endFacet(start: number): void {
    if (!this.#insideFacet) throw this.#malformed(start, 'an "endfacet" has no facet before it');
    this.#insideFacet = false;
    if (!this.#faces.end(start)) throw this.#malformed(start, 'the facet has fewer than three vertices');
  }

  #malformed(offset: number, what: string): Error {
    const scanner = this.#scanner;
    return refusal('malformed-file', scanner.name, scanner.placeAt(offset), `${what}; export it again.`);
  }
}
