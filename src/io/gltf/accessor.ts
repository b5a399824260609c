import { viewOf } from '../bytes.ts';
import { refusal } from '../refuse.ts';
import type { GltfDocument, Json } from './document.ts';

const componentSizes: Readonly<Record<number, number>> = {
  5120: 1,
  5121: 1,
  5122: 2,
  5123: 2,
  5125: 4,
  5126: 4,
};
const componentCounts: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const float32 = 5126;
/** Value of 1 for normalised whole numbers. */
const unitOf: Readonly<Record<number, number>> = { 5120: 127, 5121: 255, 5122: 32767, 5123: 65535 };

/** Elements side by side in a buffer. */
interface Strided {
  readonly buffer: number;
  /** Byte offset of the first element in its buffer. */
  readonly offset: number;
  readonly stride: number;
}

/** One accessor: where each of its elements stands, as numbers and for overwriting. Sparse ones included. */
export class Accessor {
  readonly index: number;
  readonly count: number;
  /** Numbers per element. */
  readonly components: number;
  readonly isFloat: boolean;
  readonly #document: GltfDocument;
  readonly #componentType: number;
  readonly #unit: number;
  readonly #base: Strided | undefined;
  readonly #sparse: Strided | undefined;
  /** Element → its place among the sparse values. */
  readonly #sparseSlots = new Map<number, number>();

  /** @throws index-out-of-range, malformed-file, truncated-file, unsupported-file */
  constructor(document: GltfDocument, index: unknown, user: string) {
    const json = document.element('accessors', index, user);
    this.index = index as number;
    const place = `accessor ${this.index}`;
    this.#document = document;
    this.#componentType = document.count(json.componentType, place);
    this.isFloat = this.#componentType === float32;
    this.components = Object.hasOwn(componentCounts, String(json.type))
      ? componentCounts[String(json.type)]
      : 0;
    if (this.components === 0 || !Object.hasOwn(componentSizes, this.#componentType)) {
      throw document.malformed(place, 'its type is not one that meshes use');
    }
    this.#unit = json.normalized === true && !this.isFloat ? (unitOf[this.#componentType] ?? 1) : 1;
    this.count = document.count(json.count, place);
    const size = this.components * componentSizes[this.#componentType];
    if (json.bufferView !== undefined) this.#base = this.#locate(json, this.count, size, place);
    if (json.sparse !== undefined) this.#sparse = this.#readSparse(json, size, place);
  }

  /** All elements as numbers, #count×components. */
  read(): Float64Array<ArrayBuffer> {
    this.#document.spend(this.count, `accessor ${this.index}`);
    const values = new Float64Array(this.count * this.components);
    const size = componentSizes[this.#componentType];
    if (this.#base) {
      const { buffer, offset, stride } = this.#base;
      const view = viewOf(this.#document.buffer(buffer));
      for (let i = 0; i < this.count; i++) {
        for (let k = 0; k < this.components; k++) {
          values[i * this.components + k] = this.#get(view, offset + i * stride + k * size);
        }
      }
    }
    for (const i of this.#sparseSlots.keys()) {
      const view = viewOf(this.#document.buffer(this.#sparse!.buffer));
      const at = this.offsetOf(i);
      for (let k = 0; k < this.components; k++)
        values[i * this.components + k] = this.#get(view, at + k * size);
    }
    return values;
  }

  /** Whether every element is stored somewhere. */
  get isWhole(): boolean {
    return this.#base !== undefined || this.#sparseSlots.size === this.count;
  }

  /** A buffer that holds some of it, or the first one. */
  get anyBuffer(): number {
    return this.#base?.buffer ?? this.#sparse?.buffer ?? 0;
  }

  /** The buffer that holds element `i`, or −1 for an element that is zero because nothing is stored. */
  bufferOf(i: number): number {
    return this.#sparseSlots.has(i) ? this.#sparse!.buffer : (this.#base?.buffer ?? -1);
  }

  /** Byte offset of element `i` in its buffer. */
  offsetOf(i: number): number {
    const slot = this.#sparseSlots.get(i);
    if (slot !== undefined) return this.#sparse!.offset + slot * this.#sparse!.stride;
    return this.#base!.offset + i * this.#base!.stride;
  }

  /** Overwrites one number; normalised whole numbers are rounded. */
  set(view: DataView, element: number, component: number, value: number): void {
    const at = this.offsetOf(element) + component * componentSizes[this.#componentType];
    const whole = Math.round(value * this.#unit);
    if (this.isFloat) view.setFloat32(at, value, true);
    else if (this.#componentType === 5120) view.setInt8(at, whole);
    else if (this.#componentType === 5121) view.setUint8(at, whole);
    else if (this.#componentType === 5122) view.setInt16(at, whole, true);
    else if (this.#componentType === 5123) view.setUint16(at, whole, true);
    else view.setUint32(at, whole, true);
  }

  #get(view: DataView, at: number): number {
    switch (this.#componentType) {
      case float32:
        return view.getFloat32(at, true);
      case 5125:
        return view.getUint32(at, true);
      case 5123:
        return view.getUint16(at, true) / this.#unit;
      case 5122:
        return Math.max(-this.#unit, view.getInt16(at, true)) / this.#unit || 0;
      case 5121:
        return view.getUint8(at) / this.#unit;
      default:
        return view.getInt8(at) / this.#unit;
    }
  }

  /** Where `count` elements of `size` bytes stand, checked against their buffer view and buffer. */
  #locate(json: Json, count: number, size: number, place: string): Strided {
    const document = this.#document;
    const view = document.element('bufferViews', json.bufferView, place);
    const viewPlace = `buffer view ${json.bufferView}`;
    const compressed = Object.keys(document.record(view.extensions ?? {}, viewPlace)).find((key) =>
      /meshopt/i.test(key),
    );
    if (compressed) {
      const sentence = 'it is compressed with meshopt; open it with an engine, which loads the decoder.';
      throw refusal('unsupported-file', document.name, viewPlace, sentence);
    }
    const buffer = document.count(view.buffer, viewPlace);
    const held = document.buffer(buffer).length;
    const begin = document.count(view.byteOffset, viewPlace);
    const length = document.count(view.byteLength, viewPlace);
    const offset = document.count(json.byteOffset, place);
    const stride = document.count(view.byteStride, viewPlace) || size;
    if (begin + length > held) throw this.#outOfBounds(viewPlace, 'buffer', begin + length, held);
    const needed = offset + (count === 0 ? 0 : stride * (count - 1) + size);
    if (needed > length) throw this.#outOfBounds(place, 'buffer view', needed, length);
    return { buffer, offset: begin + offset, stride };
  }

  #outOfBounds(place: string, what: string, needed: number, held: number): Error {
    const sentence = `it reaches to byte ${needed} of a ${what} that has ${held}; the file was cut off or is broken. Export it again.`;
    return refusal('truncated-file', this.#document.name, place, sentence);
  }

  #readSparse(json: Json, size: number, accessorPlace: string): Strided {
    const document = this.#document;
    const place = `${accessorPlace} (sparse)`;
    const sparse = document.record(json.sparse, place);
    const count = document.count(sparse.count, place);
    const indices = document.record(sparse.indices, place);
    const type = document.count(indices.componentType, place);
    if (type !== 5121 && type !== 5123 && type !== 5125)
      throw document.malformed(place, 'its indices have no type');
    const indexSize = componentSizes[type];
    const where = this.#locate(indices, count, indexSize, place);
    const view = viewOf(document.buffer(where.buffer));
    document.spend(count, place);
    for (let slot = 0; slot < count; slot++) {
      const at = where.offset + slot * indexSize;
      const element =
        indexSize === 1
          ? view.getUint8(at)
          : indexSize === 2
            ? view.getUint16(at, true)
            : view.getUint32(at, true);
      if (element >= this.count) {
        const sentence = `it names element ${element} of ${this.count}; export the file again.`;
        throw refusal('index-out-of-range', document.name, place, sentence, element);
      }
      this.#sparseSlots.set(element, slot);
    }
    return this.#locate(document.record(sparse.values, place), count, size, place);
  }
}
