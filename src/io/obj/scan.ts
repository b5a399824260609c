import { isTokenEnd } from '../bytes.ts';
import { linearColors } from '../color.ts';
import { FaceCollector } from '../faces.ts';
import { FloatList, IndexList } from '../lists.ts';
import { none, type ParsedFile } from '../parsed-file.ts';
import { settlePlaceless } from '../placeless.ts';
import { quote, refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';

/** An OBJ file and where its numbers stand. */
export interface ObjFile extends ParsedFile {
  /** #P byte offsets just behind each `v`. */
  readonly positionOffsets: Uint32Array;
  /** #N×3 */
  readonly normals: Float64Array;
  /** #N byte offsets just behind each `vn`. */
  readonly normalOffsets: Uint32Array;
  /** #C index of the normal of each corner, or {@link none}; empty if no corner has one. */
  readonly normalOfCorner: Uint32Array;
  /** Byte offsets of statements that may name groups, materials or files. */
  readonly statementOffsets: Uint32Array;
  /** How many faces stand before each of these. */
  readonly facesBefore: Uint32Array;
}

const lf = 10;
const slash = 47;
const letterF = 102;
const letterG = 103;
const letterM = 109;
const letterN = 110;
const letterO = 111;
const letterT = 116;
const letterU = 117;
const letterV = 118;

/**
 * Reads Wavefront OBJ: `v` (with colours or a weight behind), `vn`, `f` with every kind of reference. All other
 * statements are left to the file.
 *
 * @throws no-faces, index-out-of-range, malformed-file, truncated-file, not-finite
 */
export function scanObj(bytes: Uint8Array, name: string): ObjFile {
  return new ObjScan(bytes, name).run();
}

class ObjScan {
  readonly #scanner: TextScanner;
  readonly #positions = new FloatList();
  readonly #positionOffsets = new IndexList();
  readonly #colors = new FloatList();
  readonly #normals = new FloatList();
  readonly #normalOffsets = new IndexList();
  readonly #faces = new FaceCollector();
  readonly #normalOfCorner = new IndexList();
  readonly #uvs = new FloatList();
  readonly #uvOfCorner = new IndexList();
  readonly #statementOffsets = new IndexList();
  readonly #facesBefore = new IndexList();
  readonly #extra = new Float64Array(5);

  constructor(bytes: Uint8Array, name: string) {
    this.#scanner = new TextScanner(bytes, name);
  }

  run(): ObjFile {
    const scanner = this.#scanner;
    const { bytes } = scanner;
    for (; !scanner.done; scanner.nextLine()) {
      const first = scanner.peekInLine();
      if (first !== letterV && first !== letterF) {
        if (mayName(first)) this.#note();
        continue;
      }
      const second = bytes[++scanner.at];
      if (first === letterF) {
        if (isBlank(second)) this.#face();
      } else if (isBlank(second)) {
        this.#vertex();
      } else if (isBlank(bytes[scanner.at + 1])) {
        scanner.at++;
        if (second === letterN) this.#normal();
        else if (second === letterT) this.#uv();
      }
    }
    return this.#finish();
  }

  #note(): void {
    this.#statementOffsets.push(this.#scanner.at);
    this.#facesBefore.push(this.#faces.faceCount);
  }

  #vertex(): void {
    const scanner = this.#scanner;
    this.#positionOffsets.push(scanner.at);
    const x = scanner.anyNumberInLine('the x of the vertex');
    const y = scanner.anyNumberInLine('the y of the vertex');
    this.#positions.push3(x, y, scanner.anyNumberInLine('the z of the vertex'));
    if (scanner.peekInLine() !== lf) this.#colorBehind();
  }

  /** Three numbers behind the position, or four (a colour with alpha), are a colour; one alone is a weight. */
  #colorBehind(): void {
    const scanner = this.#scanner;
    const extra = this.#extra;
    let count = 0;
    for (; count < 5 && scanner.peekInLine() !== lf; count++) {
      const value = scanner.decimal();
      if (Number.isNaN(value)) break;
      extra[count] = value;
    }
    if (count !== 3 && count !== 4) return;
    const here = this.#positions.length - 3;
    while (this.#colors.length < here) this.#colors.push(Number.NaN);
    this.#colors.push3(extra[0], extra[1], extra[2]);
  }

  #normal(): void {
    this.#normalOffsets.push(this.#scanner.at);
    for (let axis = 0; axis < 3; axis++) this.#normals.push(this.#lenientNumber());
  }

  #uv(): void {
    const u = this.#lenientNumber();
    this.#uvs.push2(u, this.#lenientNumber());
  }

  /** A number that is not needed to read the shape: NaN, or its absence, is no reason to refuse the file. */
  #lenientNumber(): number {
    const scanner = this.#scanner;
    if (scanner.peekInLine() === lf) return Number.NaN;
    const value = scanner.decimal();
    if (Number.isNaN(value)) scanner.skipWord();
    return value;
  }

  #face(): void {
    const scanner = this.#scanner;
    const { bytes } = scanner;
    const begin = scanner.at;
    while (scanner.peekInLine() !== lf) {
      this.#faces.corner(this.#reference(this.#positionOffsets.length));
      if (bytes[scanner.at] === slash) {
        scanner.at++;
        this.#attribute(this.#uvOfCorner, this.#uvs.length / 2);
        if (bytes[scanner.at] === slash) {
          scanner.at++;
          this.#attribute(this.#normalOfCorner, this.#normalOffsets.length);
        }
      }
      if (!isTokenEnd(bytes, scanner.at)) throw this.#badReference();
    }
    this.#endFace(begin);
  }

  /** Notes which texture coordinate or normal the latest corner names, if it names one; `count` of them stand before it. */
  #attribute(ofCorner: IndexList, count: number): void {
    const given = this.#scanner.integer();
    const index = given > 0 ? given - 1 : count + given;
    if (!(given !== 0 && index >= 0)) return; // also if it is no number
    ofCorner.padTo(this.#faces.cornerCount - 1, none);
    ofCorner.push(index);
  }

  #endFace(begin: number): void {
    const scanner = this.#scanner;
    if (this.#faces.end(begin)) return;
    if (scanner.done) {
      const sentence = 'the file ends in the middle of a face; it was cut off. Export it again.';
      throw refusal('truncated-file', scanner.name, scanner.placeAt(begin), sentence);
    }
    for (const ofCorner of [this.#normalOfCorner, this.#uvOfCorner])
      ofCorner.length = Math.min(ofCorner.length, this.#faces.cornerCount);
  }

  /** Index from 0 of the vertex that a face names; what lies beyond the last one so far may still come. */
  #reference(count: number): number {
    const scanner = this.#scanner;
    const start = scanner.at;
    const given = scanner.integer();
    if (given > 0) return given - 1;
    if (given < 0 && count + given >= 0) return count + given;
    scanner.at = start;
    if (Number.isNaN(given)) throw this.#badReference();
    const sentence =
      given === 0
        ? 'the face uses vertex 0, but OBJ counts vertices from 1; export it again.'
        : `the face uses vertex ${given}, but only ${count} stand before it; export it again.`;
    throw refusal(
      'index-out-of-range',
      scanner.name,
      scanner.placeAt(start),
      sentence,
      this.#faces.faceCount,
    );
  }

  #badReference(): Error {
    const scanner = this.#scanner;
    const place = scanner.placeAt(scanner.at);
    const sentence = `the face names ${quote(scanner.word())}, which is no vertex; export it again.`;
    return refusal('malformed-file', scanner.name, place, sentence, this.#faces.faceCount);
  }

  #finish(): ObjFile {
    const scanner = this.#scanner;
    const describe = (offset: number) => scanner.placeAt(offset);
    const positions = this.#positions.take();
    const faces = this.#faces.finish(scanner.name, positions.length / 3, describe, 1);
    const positionOffsets = this.#positionOffsets.take();
    const { placeless, warnings } = settlePlaceless(positions, faces.corners, (p) =>
      scanner.badPosition(positionOffsets[p], 'the vertex'),
    );
    const hasNormals = this.#normalOfCorner.length > 0;
    if (hasNormals) this.#normalOfCorner.padTo(faces.corners.length, none);
    const normalOfCorner = this.#normalOfCorner.take();
    const normalCount = this.#normalOffsets.length;
    for (let c = 0; c < normalOfCorner.length; c++) {
      if (normalOfCorner[c] >= normalCount) normalOfCorner[c] = none;
    }
    return {
      positions,
      ...(placeless ? { placeless } : {}),
      faces,
      ...this.#finishColors(positions.length),
      ...this.#finishUvs(faces.corners.length),
      warnings: [...this.#faces.warnings(describe), ...warnings],
      positionOffsets,
      normals: this.#normals.take(),
      normalOffsets: this.#normalOffsets.take(),
      normalOfCorner,
      statementOffsets: this.#statementOffsets.take(),
      facesBefore: this.#facesBefore.take(),
    };
  }

  #finishUvs(corners: number): { uvs?: Float32Array<ArrayBuffer> } {
    const ofCorner = this.#uvOfCorner;
    if (ofCorner.length === 0) return {};
    ofCorner.padTo(corners, none);
    const values = this.#uvs.take();
    const indices = ofCorner.take();
    const uvs = new Float32Array(2 * corners).fill(Number.NaN);
    for (let c = 0; c < corners; c++) {
      if (2 * indices[c] < values.length) uvs.set(values.subarray(2 * indices[c], 2 * indices[c] + 2), 2 * c);
    }
    return { uvs };
  }

  #finishColors(length: number): { colors?: Float32Array<ArrayBuffer> } {
    if (this.#colors.length === 0) return {};
    while (this.#colors.length < length) this.#colors.push(Number.NaN);
    return { colors: linearColors(this.#colors.take()) };
  }
}

/** Whether a statement that begins so may be `o`, `g`, `usemtl` or `mtllib`. */
function mayName(first: number): boolean {
  return first === letterO || first === letterG || first === letterU || first === letterM;
}

/** A blank, or the continuation of the line. */
function isBlank(c: number): boolean {
  return c === 32 || c === 9 || c === 92;
}
