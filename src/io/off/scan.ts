import { linearColors } from '../color.ts';
import { FaceCollector } from '../faces.ts';
import { FloatList, IndexList, uvsOfCorners } from '../lists.ts';
import type { ParsedFile } from '../parsed-file.ts';
import { settlePlaceless } from '../placeless.ts';
import { counted, refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';
import { offKeyword, refuseOffKind } from './header.ts';

/** An OFF file and where its numbers stand. */
export interface OffFile extends ParsedFile {
  /** #P byte offsets at each vertex. */
  readonly positionOffsets: Uint32Array;
  /** #P×3; empty if the file has no normals. They stand right behind the positions. */
  readonly normals: Float64Array;
}

const lf = 10;

/**
 * Reads OFF, COFF, NOFF, STOFF and their combinations, in text. The keyword may be in small letters, be glued to the number of
 * vertices, or be missing.
 *
 * A line holds one vertex or one face, and what stands behind it on the line (a colour) says nothing of the shape; only a file
 * with fewer lines than vertices and faces has several of them on a line.
 *
 * @throws no-faces, index-out-of-range, malformed-file, truncated-file, not-finite, unsupported-file
 */
export function scanOff(bytes: Uint8Array, name: string): OffFile {
  return new OffScan(bytes, name).run();
}

class OffScan {
  readonly #scanner: TextScanner;
  readonly #positions = new FloatList();
  readonly #offsets = new IndexList();
  readonly #normals = new FloatList();
  readonly #colors = new FloatList();
  readonly #uvs = new FloatList();
  readonly #faces = new FaceCollector();
  #hasUvs = false;
  #hasColors = false;
  #hasNormals = false;
  /** Several vertices or faces stand on a line. */
  #isPacked = false;

  constructor(bytes: Uint8Array, name: string) {
    this.#scanner = new TextScanner(bytes, name);
  }

  run(): OffFile {
    const scanner = this.#scanner;
    this.#keyword();
    const vertices = this.#count('vertices');
    const faces = this.#count('faces');
    if (scanner.peekInLine() !== lf) scanner.skipWord(); // the number of edges
    this.#checkCounts(vertices, faces);
    const two = 2 * this.#numbersOfVertex();
    this.#isPacked = isPacked(scanner, vertices, vertices + faces, ({ length }) => length >= two);
    for (let v = 0; v < vertices; v++) this.#vertex(v);
    this.#isPacked = isPacked(scanner, faces, faces, hasTwoFaces);
    for (let f = 0; f < faces; f++) this.#face(f);
    return this.#finish(vertices);
  }

  #finish(vertices: number): OffFile {
    const scanner = this.#scanner;
    const describe = (offset: number) => scanner.placeAt(offset);
    const faces = this.#faces.finish(scanner.name, vertices, describe, 0);
    const positions = this.#positions.take();
    const positionOffsets = this.#offsets.take();
    const { placeless, warnings } = settlePlaceless(positions, faces.corners, (v) =>
      scanner.badPosition(positionOffsets[v], `vertex ${v}`),
    );
    return {
      positions,
      ...(placeless ? { placeless } : {}),
      faces,
      ...(this.#hasColors ? { colors: linearColors(this.#colors.take()) } : {}),
      ...(this.#hasUvs ? { uvs: uvsOfCorners(this.#uvs.take(), faces.corners) } : {}),
      warnings: [...this.#faces.warnings(describe), ...warnings],
      positionOffsets,
      normals: this.#normals.take(),
    };
  }

  #keyword(): void {
    const scanner = this.#scanner;
    scanner.peek();
    const { at } = scanner;
    const found = offKeyword(scanner.word());
    // Without a keyword the counts come first; there are three coordinates then.
    scanner.at = at + (found?.length ?? 0);
    if (!found) return;
    this.#hasUvs = found.hasUvs;
    this.#hasColors = found.hasColors;
    this.#hasNormals = found.hasNormals;
    const place = scanner.placeAt(at);
    if (scanner.peekInLine() !== lf && this.#sees('BINARY')) {
      throw refuseOffKind('binary OFF', scanner.name, place);
    }
    if (found.hasOtherDimensions) {
      throw refuseOffKind('OFF in other than three dimensions', scanner.name, place);
    }
  }

  #numbersOfVertex(): number {
    return 3 + (this.#hasNormals ? 3 : 0) + (this.#hasColors ? 4 : 0) + (this.#hasUvs ? 2 : 0);
  }

  #sees(word: string): boolean {
    const start = this.#scanner.at;
    const found = this.#scanner.word().toUpperCase() === word;
    this.#scanner.at = start;
    return found;
  }

  #count(what: string): number {
    const scanner = this.#scanner;
    scanner.peek();
    const start = scanner.at;
    const count = scanner.number(`the number of ${what}`);
    if (Number.isInteger(count) && count >= 0) return count;
    const sentence = `the number of ${what} is ${count}; it must be a whole number from 0. Export it again.`;
    throw refusal('malformed-file', scanner.name, scanner.placeAt(start), sentence);
  }

  /** A vertex takes six bytes ("0 0 0\n") and a face two, so a header cannot promise more than the file can hold. */
  #checkCounts(vertices: number, faces: number): void {
    const scanner = this.#scanner;
    if (6 * vertices + 2 * faces <= scanner.bytes.length - scanner.at + 2) return;
    const promise = `${counted(vertices, 'vertex', 'vertices')} and ${counted(faces, 'face')}`;
    const sentence = `the header promises ${promise}, more than the file can hold; it was cut off. Export it again.`;
    throw refusal('truncated-file', scanner.name, scanner.placeAt(scanner.at), sentence);
  }

  #vertex(v: number): void {
    const scanner = this.#scanner;
    scanner.peek();
    this.#offsets.push(scanner.at);
    this.#three(this.#positions, `vertex ${v}`);
    if (this.#hasNormals) this.#three(this.#normals, `the normal of vertex ${v}`);
    if (this.#hasColors) for (let i = 0; i < 3; i++) this.#colors.push(this.#number());
    if (this.#isPacked) {
      if (this.#hasColors) this.#number(); // opacity
      if (this.#hasUvs) this.#uvs.push2(this.#number(), this.#number());
      return;
    }
    if (this.#hasUvs) this.#lastTwo();
    scanner.nextLine();
  }

  /** Three numbers, finite or not: it depends on who uses them. */
  #three(into: FloatList, of: string): void {
    const scanner = this.#scanner;
    const x = scanner.anyNumber(`the x of ${of}`);
    const y = scanner.anyNumber(`the y of ${of}`);
    into.push3(x, y, scanner.anyNumber(`the z of ${of}`));
  }

  /** A number of this line; NaN if it is none or not there. */
  #number(): number {
    const scanner = this.#scanner;
    if (scanner.peekInLine() === lf) return Number.NaN;
    const value = scanner.decimal();
    if (Number.isNaN(value)) scanner.skipWord();
    return value;
  }

  /** Texture coordinates end the line; how many numbers a colour takes before them is not fixed. */
  #lastTwo(): void {
    let [u, v] = [Number.NaN, Number.NaN];
    while (this.#scanner.peekInLine() !== lf) {
      u = v;
      v = this.#number();
    }
    this.#uvs.push2(u, v);
  }

  #face(f: number): void {
    const scanner = this.#scanner;
    scanner.peek();
    const start = scanner.at;
    const count = this.#count('corners');
    if (2 * count > scanner.bytes.length - scanner.at + 1) {
      const sentence = `face ${f} promises ${counted(count, 'corner')}, more than the file can hold; export it again.`;
      throw refusal('truncated-file', scanner.name, scanner.placeAt(start), sentence, f);
    }
    for (let c = 0; c < count; c++) this.#faces.corner(this.#corner(f));
    this.#faces.end(start);
    if (!this.#isPacked) scanner.nextLine(); // a colour may follow
  }

  #corner(f: number): number {
    const scanner = this.#scanner;
    scanner.peek();
    const start = scanner.at;
    const index = scanner.number(`a corner of face ${f}`);
    if (Number.isInteger(index) && index >= 0) return Math.min(index, 0xfffffffe);
    const sentence = `face ${f} uses vertex ${index}, but OFF counts vertices from 0; export it again.`;
    throw refusal('index-out-of-range', scanner.name, scanner.placeAt(start), sentence, f);
  }
}

/**
 * Whether several rows stand on a line: there are fewer lines than rows, and not because the file was cut off, as one line has
 * room for two.
 *
 * @param first how many rows the block has that comes next
 * @param rows how many there are to the end of the file
 * @param hasTwo whether a line of the block holds two rows, by its numbers
 */
function isPacked(
  here: TextScanner,
  first: number,
  rows: number,
  hasTwo: (numbers: readonly number[]) => boolean,
): boolean {
  if (linesFrom(here, rows) === rows) return false;
  const scanner = new TextScanner(here.bytes, here.name, here.at);
  for (let line = 0; line < first && scanner.peek() >= 0; line++, scanner.nextLine())
    if (hasTwo(numbersOfLine(scanner))) return true;
  return false;
}

/** Lines with something on them, from here to the end, but not more than there need to be. */
function linesFrom({ bytes, name, at }: TextScanner, most: number): number {
  const scanner = new TextScanner(bytes, name, at);
  let lines = 0;
  for (; lines < most && scanner.peek() >= 0; scanner.nextLine()) lines++;
  return lines;
}

/** Whether the numbers behind a face are a face again, and not its colour. */
function hasTwoFaces(numbers: readonly number[]): boolean {
  const next = numbers[0] + 1;
  return numbers[next] >= 3 && numbers.length > next + numbers[next];
}

function numbersOfLine(scanner: TextScanner): number[] {
  const numbers: number[] = [];
  while (scanner.peekInLine() !== lf) {
    const { at } = scanner;
    numbers.push(scanner.decimal());
    if (scanner.at === at) scanner.skipWord();
  }
  return numbers;
}
