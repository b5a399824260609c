import { linearColors } from '../color.ts';
import { FaceCollector } from '../faces.ts';
import { FloatList, IndexList, uvsOfCorners } from '../lists.ts';
import type { ParsedFile } from '../parsed-file.ts';
import { counted, quote, refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';

/** An OFF file and where its numbers stand. */
export interface OffFile extends ParsedFile {
  /** #P byte offsets at each vertex. */
  readonly positionOffsets: Uint32Array;
  /** #P×3; empty if the file has no normals. They stand right behind the positions. */
  readonly normals: Float64Array;
}

const lf = 10;

/** Matches the first word of an OFF file: texture coordinates, colours, normals, four dimensions, any dimensions. */
export const offKeyword = /^(ST)?(C)?(N)?(4)?(n)?OFF$/;

/**
 * Reads OFF, COFF, NOFF, STOFF and their combinations, in text.
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

  constructor(bytes: Uint8Array, name: string) {
    this.#scanner = new TextScanner(bytes, name);
  }

  run(): OffFile {
    const scanner = this.#scanner;
    this.#keyword();
    const vertices = this.#count('vertices');
    const faces = this.#count('faces');
    scanner.nextLine(); // the number of edges, if it is there
    this.#checkCounts(vertices, faces);
    for (let v = 0; v < vertices; v++) this.#vertex(v);
    for (let f = 0; f < faces; f++) this.#face(f);
    const positions = this.#positions.take();
    const describe = (offset: number) => scanner.placeAt(offset);
    const meshFaces = this.#faces.finish(scanner.name, vertices, describe, 0);
    return {
      positions,
      faces: meshFaces,
      ...(this.#hasColors ? { colors: linearColors(this.#colors.take()) } : {}),
      ...(this.#hasUvs ? { uvs: uvsOfCorners(this.#uvs.take(), meshFaces.corners) } : {}),
      warnings: this.#faces.warnings(describe),
      positionOffsets: this.#offsets.take(),
      normals: this.#normals.take(),
    };
  }

  #keyword(): void {
    const scanner = this.#scanner;
    scanner.peek();
    const place = scanner.placeAt(scanner.at);
    const word = scanner.word();
    const found = offKeyword.exec(word);
    if (!found) {
      throw refusal(
        'malformed-file',
        scanner.name,
        place,
        `${quote(word)} is not an OFF header; export it again.`,
      );
    }
    const [, uvs, colors, normals, four, any] = found;
    this.#hasUvs = uvs !== undefined;
    this.#hasColors = colors !== undefined;
    this.#hasNormals = normals !== undefined;
    const isBinary = scanner.peekInLine() !== lf && this.#sees('BINARY');
    if (four === undefined && any === undefined && !isBinary) return;
    const kind = isBinary ? 'binary OFF' : 'OFF in other than three dimensions';
    throw refusal(
      'unsupported-file',
      scanner.name,
      place,
      `${kind} is not read; export plain OFF, OBJ or PLY.`,
    );
  }

  #sees(word: string): boolean {
    const start = this.#scanner.at;
    const found = this.#scanner.word() === word;
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
    const x = scanner.number(`the x of vertex ${v}`);
    const y = scanner.number(`the y of vertex ${v}`);
    this.#positions.push3(x, y, scanner.number(`the z of vertex ${v}`));
    if (this.#hasNormals) {
      const nx = scanner.number(`the normal of vertex ${v}`);
      const ny = scanner.number(`the normal of vertex ${v}`);
      this.#normals.push3(nx, ny, scanner.number(`the normal of vertex ${v}`));
    }
    if (this.#hasColors) {
      for (let i = 0; i < 3; i++)
        this.#colors.push(scanner.peekInLine() === lf ? Number.NaN : scanner.decimal());
    }
    if (this.#hasUvs) this.#lastTwo();
    scanner.nextLine();
  }

  /** Texture coordinates end the line; how many numbers a colour takes before them is not fixed. */
  #lastTwo(): void {
    const scanner = this.#scanner;
    let [u, v] = [Number.NaN, Number.NaN];
    while (scanner.peekInLine() !== lf) {
      u = v;
      v = scanner.decimal();
      if (Number.isNaN(v)) break;
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
    scanner.nextLine(); // a colour may follow
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
