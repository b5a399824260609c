import { type FilesBeside, findBeside, nothingBeside, type Reference, tidyPath } from '../beside.ts';
import { hasByteOrderMark, viewOf } from '../bytes.ts';
import { counted, quote, refusal } from '../refuse.ts';
import { decodeBase64 } from './base64.ts';

/** Parsed JSON, nothing about it known yet. */
export type Json = Readonly<Record<string, unknown>>;

const glbHeader = 12;
const chunkHeader = 8;
const jsonChunk = 0x4e4f534a;
const binChunk = 0x004e4942;

/** Where the parts of a glTF or GLB file stand, in bytes: [begin, end). */
interface Layout {
  readonly json: readonly [number, number];
  readonly bin?: readonly [number, number];
}

/** A buffer or an image that is in a file beside this one. */
export interface Elsewhere {
  readonly key: 'buffers' | 'images';
  readonly index: number;
  readonly path: string;
}

/** A glTF asset: its JSON, its buffers, and sentences for what is wrong with either. */
export class GltfDocument {
  readonly bytes: Uint8Array;
  readonly name: string;
  readonly layout: Layout;
  readonly isBinary: boolean;
  readonly root: Json;
  readonly filesBeside: FilesBeside;
  readonly #buffers = new Map<number, Uint8Array>();
  #budget: number;

  /** @throws malformed-file, truncated-file, unsupported-file */
  constructor(bytes: Uint8Array, name: string, isBinary: boolean, beside: FilesBeside = nothingBeside) {
    this.filesBeside = beside;
    this.bytes = bytes;
    this.name = name;
    this.isBinary = isBinary;
    this.#budget = 1e6 + 16 * bytes.length;
    this.layout = isBinary ? this.#glbLayout() : { json: [hasByteOrderMark(bytes) ? 3 : 0, bytes.length] };
    this.root = this.record(this.#parse(), 'the JSON');
    const version = this.record(this.root.asset ?? {}, 'asset').version;
    if (version !== undefined && !String(version).startsWith('2.')) {
      const sentence = `this is glTF ${String(version).slice(0, 8)}; only version 2 is read. Convert it to glTF 2.`;
      throw refusal('unsupported-file', name, 'asset', sentence);
    }
  }

  malformed(place: string, what: string): Error {
    return refusal('malformed-file', this.name, place, `${what}; export the file again.`);
  }

  /**
   * Counts elements that are about to be read. A small file may name the same data ever again; what it can ask for in
   * all is bounded by its length.
   *
   * @throws too-large
   */
  spend(elements: number, place: string): void {
    this.#budget -= elements;
    if (this.#budget >= 0) return;
    const sentence = 'it unfolds to far more data than the file holds; split the model.';
    throw refusal('too-large', this.name, place, sentence);
  }

  /** An object, checked. */
  record(value: unknown, place: string): Json {
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Json;
    throw this.malformed(place, 'an object was expected');
  }

  /** A list of the document ("meshes"), or an empty one. */
  list(owner: Json, key: string): readonly unknown[] {
    const value = owner[key];
    if (value === undefined) return [];
    if (!Array.isArray(value)) throw this.malformed(key, 'a list was expected');
    return value;
  }

  /** Element `index` of one of the document's lists. */
  element(key: string, index: unknown, user: string): Json {
    const list = this.list(this.root, key);
    if (typeof index === 'number' && Number.isInteger(index) && index >= 0 && index < list.length) {
      return this.record(list[index], `${key}[${index}]`);
    }
    const sentence = `it refers to ${key}[${String(index).slice(0, 24)}], but there are ${list.length} of them; export the file again.`;
    throw refusal('index-out-of-range', this.name, user, sentence);
  }

  /** A whole number from 0, checked. */
  count(value: unknown, place: string, absent = 0): number {
    if (value === undefined) return absent;
    if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
    throw this.malformed(place, `${String(value).slice(0, 24)} is not a whole number from 0`);
  }

  /** A list of finite numbers, checked. */
  numbers(value: unknown, length: number, place: string, absent: readonly number[]): readonly number[] {
    if (value === undefined) return absent;
    const isGood = Array.isArray(value) && value.length === length && value.every(Number.isFinite);
    if (!isGood) throw this.malformed(place, `${length} finite numbers were expected`);
    return value;
  }

  /** The bytes of a buffer, decoded once. @throws unsupported-file if it is in another file */
  buffer(index: number): Uint8Array {
    let bytes = this.#buffers.get(index);
    if (!bytes) {
      bytes = this.#loadBuffer(index);
      this.#buffers.set(index, bytes);
    }
    return bytes;
  }

  #loadBuffer(index: number): Uint8Array {
    const place = `buffer ${index}`;
    const { uri, byteLength } = this.element('buffers', index, place);
    const bytes = uri === undefined ? this.#binChunk(place) : this.#dataUri(uri, place);
    const needed = this.count(byteLength, place, bytes.length);
    if (needed <= bytes.length) return bytes.subarray(0, needed);
    const sentence = `it should have ${counted(needed, 'byte')}, but only ${bytes.length} are there; the file was cut off. Get it again.`;
    throw refusal('truncated-file', this.name, place, sentence);
  }

  #binChunk(place: string): Uint8Array {
    const { bin } = this.layout;
    if (!bin)
      throw refusal('truncated-file', this.name, place, 'its data is missing; export the file again.');
    return this.bytes.subarray(bin[0], bin[1]);
  }

  #dataUri(uri: unknown, place: string): Uint8Array {
    if (typeof uri !== 'string') throw this.malformed(place, 'its uri is not a text');
    if (!/^data:/i.test(uri)) return this.#fileBeside(this.pathOf(uri), place);
    const comma = uri.indexOf(',');
    const bytes = /;base64$/i.test(uri.slice(0, comma)) ? decodeBase64(uri.slice(comma + 1)) : undefined;
    if (!bytes) throw this.malformed(place, 'its data URI is not base64');
    return bytes;
  }

  /** A copy: it may be written to. */
  #fileBeside(path: string, place: string): Uint8Array {
    const bytes = this.beside(path);
    if (bytes) return bytes.slice();
    const sentence = `its data is in another file, ${quote(path)}, which is not there; open both together, or put them in one folder.`;
    throw refusal('unsupported-file', this.name, place, sentence);
  }

  /** A file that lies beside this one. */
  beside(path: string): Uint8Array<ArrayBuffer> | undefined {
    return findBeside(this.filesBeside, path);
  }

  /** The path that a URI of this file means. */
  pathOf(uri: string): string {
    try {
      return tidyPath(decodeURIComponent(uri));
    } catch {
      // A stray % stands for itself.
      return tidyPath(uri);
    }
  }

  /** Buffers and images that are in files beside this one. */
  elsewhere(): Elsewhere[] {
    return (['buffers', 'images'] as const).flatMap((key) =>
      this.list(this.root, key).flatMap((element, index) => {
        const { uri } = this.record(element, key);
        const isElsewhere = typeof uri === 'string' && !/^[a-z][a-z0-9+.-]*:/i.test(uri);
        return isElsewhere ? [{ key, index, path: this.pathOf(uri) }] : [];
      }),
    );
  }

  references(): Reference[] {
    return this.elsewhere().map(({ key, path }) => ({ path, isShape: key === 'buffers' }));
  }

  #parse(): unknown {
    const [begin, end] = this.layout.json;
    let textEnd = end;
    while (textEnd > begin && this.bytes[textEnd - 1] === 0) textEnd--; // some exporters pad with zeros
    const text = new TextDecoder().decode(this.bytes.slice(begin, textEnd));
    try {
      return JSON.parse(text);
    } catch {
      // The engine's own message quotes the file and differs from browser to browser.
      const isCut = !/[}\]]\s*$/.test(text.slice(-64));
      const sentence = isCut
        ? 'the JSON ends too early; the file was cut off. Get it again in full.'
        : 'the JSON cannot be parsed; export the file again.';
      throw refusal(isCut ? 'truncated-file' : 'malformed-file', this.name, 'JSON', sentence);
    }
  }

  #glbLayout(): Layout {
    const { bytes, name } = this;
    const cutOff = (at: number) =>
      refusal(
        'truncated-file',
        name,
        `byte ${at}`,
        'the file ends too early; it was cut off. Get it again in full.',
      );
    if (bytes.length < glbHeader + chunkHeader) throw cutOff(bytes.length);
    const view = viewOf(bytes);
    const version = view.getUint32(4, true);
    if (version !== 2) {
      const sentence = `this is GLB version ${version}; only version 2 is read. Convert it to glTF 2.`;
      throw refusal('unsupported-file', name, 'byte 4', sentence);
    }
    const length = view.getUint32(8, true);
    if (length > bytes.length) throw cutOff(bytes.length);
    let json: [number, number] | undefined;
    let bin: [number, number] | undefined;
    for (let at = glbHeader; at + chunkHeader <= length; ) {
      const begin = at + chunkHeader;
      const end = begin + view.getUint32(at, true);
      const type = view.getUint32(at + 4, true);
      if (end > length) throw cutOff(length);
      if (type === jsonChunk && at === glbHeader) json = [begin, end];
      else if (type === binChunk && !bin) bin = [begin, end];
      at = end;
    }
    if (!json) throw this.malformed(`byte ${glbHeader}`, 'the first chunk is not JSON');
    return bin ? { json, bin } : { json };
  }
}
