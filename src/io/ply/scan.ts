import { linearFromSrgb } from '../color.ts';
import { FaceCollector } from '../faces.ts';
import { FloatList, IndexList, uvsOfCorners } from '../lists.ts';
import type { ParsedFile } from '../parsed-file.ts';
import { settlePlaceless } from '../placeless.ts';
import { counted, refusal } from '../refuse.ts';
import { type PlyElement, type PlyHeader, type PlyProperty, readPlyHeader } from './header.ts';
import { PlyBinary, type PlySource, PlyText } from './source.ts';

/** A PLY file and where its numbers stand. */
export interface PlyFile extends ParsedFile {
  readonly header: PlyHeader;
  readonly vertex: PlyElement;
  /** #P byte offsets at each vertex. */
  readonly rowOffsets: Uint32Array;
  /** Byte behind the last vertex. */
  readonly rowsEnd: number;
  /** #P×3; empty if the file has no normals. */
  readonly normals: Float64Array;
}

export const plyPosition: readonly string[] = ['x', 'y', 'z'];
export const plyNormal: readonly string[] = ['nx', 'ny', 'nz'];
const colorNames = ['red', 'green', 'blue'];
/** Texture coordinates of vertices go by many names. */
const uvNames: Readonly<Record<string, 'u' | 'v'>> = {
  ...{ u: 'u', s: 'u', texture_u: 'u', texture_s: 'u' },
  ...{ v: 'v', t: 'v', texture_v: 'v', texture_t: 'v' },
};
/** Slots of a vertex that we keep: position, normal, colour, texture coordinates. */
const slotNames = [...plyPosition, ...plyNormal, ...colorNames, 'u', 'v'];

/**
 * Reads PLY: text and both byte orders, any types, any elements and properties beside the ones we know.
 *
 * @throws no-faces, index-out-of-range, malformed-file, truncated-file, not-finite, unsupported-file
 */
export function scanPly(bytes: Uint8Array, name: string): PlyFile {
  return new PlyScan(bytes, name).run();
}

class PlyScan {
  readonly #name: string;
  readonly #header: PlyHeader;
  readonly #source: PlySource;
  readonly #faces = new FaceCollector();
  readonly #positions = new FloatList();
  readonly #normals = new FloatList();
  readonly #colors = new FloatList();
  readonly #vertexUvs = new FloatList();
  /** Texture coordinates of the corners so far, where faces list them. */
  readonly #cornerUvs = new FloatList();
  readonly #rowOffsets = new IndexList();
  readonly #slots = new Float64Array(slotNames.length);
  #rowsEnd = 0;

  constructor(bytes: Uint8Array, name: string) {
    this.#name = name;
    this.#header = readPlyHeader(bytes, name);
    const { encoding, bodyStart } = this.#header;
    this.#source =
      encoding === 'ascii'
        ? new PlyText(bytes, name, bodyStart)
        : new PlyBinary(bytes, name, bodyStart, encoding === 'little');
  }

  run(): PlyFile {
    const { elements } = this.#header;
    const vertex = elements.find((element) => element.name === 'vertex');
    if (
      !vertex ||
      !plyPosition.every((axis) => vertex.properties.some((p) => p.name === axis && !p.countKind))
    ) {
      const sentence = 'no element "vertex" with x, y and z is declared; export the file again.';
      throw refusal('malformed-file', this.#name, 'header', sentence);
    }
    for (const element of elements) {
      if (element.properties.length === 0) continue; // takes no bytes, however many there are said to be
      this.#checkCount(element);
      if (element === vertex) this.#readVertices(element);
      else if (element.name === 'face') this.#readFaces(element);
      else if (element.name === 'tristrips') this.#readStrips(element);
      else this.#skipElement(element);
    }
    return this.#finish(vertex);
  }

  #finish(vertex: PlyElement): PlyFile {
    const colors = this.#colors.take();
    const describe = (f: number) => `face ${f}`;
    const faces = this.#faces.finish(this.#name, vertex.count, describe, 0);
    const positions = this.#positions.take();
    const { placeless, warnings } = settlePlaceless(positions, faces.corners, (v) =>
      this.#notFinite(v, positions.subarray(3 * v, 3 * v + 3)),
    );
    return {
      header: this.#header,
      vertex,
      positions,
      ...(placeless ? { placeless } : {}),
      faces,
      ...(colors.length > 0 ? { colors: Float32Array.from(colors, linearOrWhite) } : {}),
      ...this.#finishUvs(faces.corners),
      warnings: [
        ...this.#header.warnings,
        ...this.#faces.warnings(describe),
        ...warnings,
        ...wholeNumberWarning(vertex),
      ],
      rowOffsets: this.#rowOffsets.take(),
      rowsEnd: this.#rowsEnd,
      normals: this.#normals.take(),
    };
  }

  #finishUvs(corners: Uint32Array): { uvs?: Float32Array<ArrayBuffer> } {
    if (this.#cornerUvs.length > 0) {
      while (this.#cornerUvs.length < 2 * corners.length) this.#cornerUvs.push(Number.NaN);
      return { uvs: Float32Array.from(this.#cornerUvs.take()) };
    }
    if (this.#vertexUvs.length === 0) return {};
    return { uvs: uvsOfCorners(this.#vertexUvs.take(), corners) };
  }

  /** The header's word is bounded by the length of the file before anything is stored. */
  #checkCount({ name, count, properties }: PlyElement): void {
    const source = this.#source;
    let least = 0;
    for (const { kind, countKind } of properties) least += source.leastBytes(countKind ?? kind, count);
    if (least > source.bytesLeft + properties.length) {
      const sentence = `the header promises ${counted(count, `"${name}" element`)}, more than the file can hold; it was cut off. Get it again.`;
      throw refusal('truncated-file', this.#name, 'header', sentence);
    }
    if (properties.length === 0 && name === 'vertex')
      throw this.#malformed('header', 'vertices have no x, y, z');
  }

  #readVertices({ count, properties }: PlyElement): void {
    const source = this.#source;
    const slots = this.#slots;
    const slotOf = properties.map((p) => (p.countKind ? -1 : slotNames.indexOf(plainName(p.name))));
    const hasNormals = plyNormal.every((name) => slotOf.includes(slotNames.indexOf(name)));
    const hasColors = colorNames.every((name) => slotOf.includes(slotNames.indexOf(name)));
    const hasUvs = ['u', 'v'].every((name) => slotOf.includes(slotNames.indexOf(name)));
    const colorScale = 1 / largestColor(properties);
    for (let v = 0; v < count; v++) {
      this.#rowOffsets.push(source.at);
      for (let i = 0; i < properties.length; i++) {
        const { kind } = properties[i];
        if (slotOf[i] >= 0) slots[slotOf[i]] = source.next(kind, `the end of vertex ${v}`);
        else this.#skipValue(properties[i]);
      }
      this.#positions.push3(slots[0], slots[1], slots[2]);
      if (hasNormals) this.#normals.push3(slots[3], slots[4], slots[5]);
      if (hasColors) this.#colors.push3(colorScale * slots[6], colorScale * slots[7], colorScale * slots[8]);
      if (hasUvs) this.#vertexUvs.push2(slots[9], slots[10]);
    }
    this.#rowsEnd = source.at;
  }

  #readFaces(element: PlyElement): void {
    const { count, properties } = element;
    if (!properties.some(isIndexList))
      throw this.#malformed('header', 'faces have no list of vertex indices');
    const uvs: number[] = [];
    for (let f = 0; f < count; f++) {
      const firstCorner = this.#faces.cornerCount;
      uvs.length = 0;
      for (const property of properties) {
        if (isIndexList(property)) this.#readCorners(property, f);
        else if (isUvList(property)) this.#readUvs(property, uvs);
        else this.#skipValue(property);
      }
      if (uvs.length > 0) this.#addUvs(uvs, firstCorner);
    }
  }

  #readCorners(property: PlyProperty, f: number): void {
    const length = this.#listLength(property);
    for (let c = 0; c < length; c++) this.#faces.corner(this.#vertexIndex(property, f));
    this.#faces.end(f);
  }

  #readUvs(property: PlyProperty, into: number[]): void {
    const length = this.#listLength(property);
    for (let i = 0; i < length; i++) into.push(this.#source.next(property.kind, 'the end of a face'));
  }

  /** A list of another length than two for each corner of the face says nothing. */
  #addUvs(uvs: readonly number[], firstCorner: number): void {
    const corners = this.#faces.cornerCount - firstCorner;
    if (uvs.length !== 2 * corners) return;
    while (this.#cornerUvs.length < 2 * firstCorner) this.#cornerUvs.push(Number.NaN);
    for (const value of uvs) this.#cornerUvs.push(value);
  }

  /** Strips of triangles, −1 between them; every second triangle is turned round. */
  #readStrips({ count, properties }: PlyElement): void {
    for (let s = 0; s < count; s++) {
      for (const property of properties) {
        if (!isIndexList(property)) {
          this.#skipValue(property);
          continue;
        }
        const length = this.#listLength(property);
        const strip: number[] = [];
        for (let i = 0; i < length; i++) {
          const index = this.#source.next(property.kind, `strip ${s}`);
          if (index < 0) strip.length = 0;
          else strip.push(this.#checkedIndex(index, s));
          if (strip.length >= 3) this.#stripTriangle(strip);
        }
      }
    }
  }

  #stripTriangle(strip: readonly number[]): void {
    const n = strip.length;
    const turned = n % 2 === 0 ? 1 : 0;
    this.#faces.corner(strip[n - 3 + turned]);
    this.#faces.corner(strip[n - 2 - turned]);
    this.#faces.corner(strip[n - 1]);
    this.#faces.end(this.#faces.faceCount);
  }

  #skipElement({ count, properties }: PlyElement): void {
    for (let i = 0; i < count; i++) for (const property of properties) this.#skipValue(property);
  }

  #skipValue(property: PlyProperty): void {
    this.#source.skip(property.kind, property.countKind ? this.#listLength(property) : 1);
  }

  #listLength(property: PlyProperty): number {
    const source = this.#source;
    const { at } = source;
    const length = source.next(property.countKind!, `the list "${property.name}"`);
    if (!Number.isInteger(length) || length < 0) {
      throw this.#malformed(source.place(at), `the list "${property.name}" has the length ${length}`);
    }
    if (source.leastBytes(property.kind, length) <= source.bytesLeft) return length;
    const sentence = `the list "${property.name}" promises ${length} values, more than the file holds; it was cut off. Get it again.`;
    throw refusal('truncated-file', this.#name, source.place(at), sentence);
  }

  #vertexIndex(property: PlyProperty, f: number): number {
    return this.#checkedIndex(this.#source.next(property.kind, `a corner of face ${f}`), f);
  }

  #checkedIndex(index: number, f: number): number {
    if (Number.isInteger(index) && index >= 0) return Math.min(index, 0xfffffffe);
    const sentence = `the face uses vertex ${index}, but PLY counts vertices from 0; export it again.`;
    throw refusal('index-out-of-range', this.#name, `face ${f}`, sentence, f);
  }

  #malformed(place: string, what: string): Error {
    return refusal('malformed-file', this.#name, place, `${what}; export the file again.`);
  }

  #notFinite(v: number, position: Float64Array): Error {
    const value = position.find((x) => !Number.isFinite(x));
    const sentence = `a coordinate is ${value}; repair the mesh where you made it and export it again.`;
    return refusal('not-finite', this.#name, `vertex ${v}`, sentence, v);
  }
}

/** Said when the file is opened, as its header will change. */
function wholeNumberWarning({ properties }: PlyElement): string[] {
  const isWhole = properties.some(
    ({ name, kind }) => plyPosition.includes(name) && !kind.startsWith('float'),
  );
  return isWhole
    ? [
        'Its positions are stored as whole numbers; in the result they are decimal ones, and the header says so.',
      ]
    : [];
}

function isIndexList({ name, countKind }: PlyProperty): boolean {
  return countKind !== undefined && (name === 'vertex_indices' || name === 'vertex_index');
}

/** Whether a property of faces lists u and v of each corner. */
function isUvList({ name, countKind }: PlyProperty): boolean {
  return countKind !== undefined && name === 'texcoord';
}

/** A colour that is no number becomes white, as in every format. */
function linearOrWhite(srgb: number): number {
  return Number.isNaN(srgb) ? 1 : linearFromSrgb(srgb);
}

function plainName(name: string): string {
  if (Object.hasOwn(uvNames, name)) return uvNames[name];
  return name.startsWith('diffuse_') ? name.slice('diffuse_'.length) : name;
}

function largestColor(properties: readonly PlyProperty[]): number {
  const red = properties.find((property) => plainName(property.name) === 'red');
  if (red?.kind.startsWith('float')) return 1;
  return red?.kind.endsWith('16') ? 65535 : 255;
}
