import { ByteWriter } from '../byte-writer.ts';
import { concatenate, encodeUtf8, viewOf } from '../bytes.ts';
import { encodeBase64 } from './base64.ts';
import { GltfDocument } from './document.ts';
import { imageInside } from './images.ts';
import { elementSpans, memberSpan, type Span, valueSpan } from './json-spans.ts';

interface Replacement {
  readonly span: Span;
  readonly text: string;
}

/**
 * A copy of a glTF file in which single values of the JSON are replaced, numbers of buffers overwritten, and bytes put behind
 * buffers. What is not touched stays byte for byte.
 */
export class GltfAssembly {
  /** Over the copy; its buffers are what is written to. */
  readonly document: GltfDocument;
  readonly #result: Uint8Array<ArrayBuffer>;
  readonly #isGlb: boolean;
  readonly #root: Span;
  readonly #views = new Map<number, DataView>();
  readonly #appended = new Map<number, Uint8Array[]>();
  readonly #replacements: Replacement[] = [];
  readonly #newElements = new Map<string, string[]>();

  constructor(source: GltfDocument) {
    this.#result = new Uint8Array(source.bytes);
    this.#isGlb = source.isBinary;
    this.document = new GltfDocument(this.#result, source.name, this.#isGlb, source.filesBeside);
    this.#root = valueSpan(this.#result, this.document.layout.json[0]);
  }

  /** Whether anything was written. */
  get isTouched(): boolean {
    return this.#views.size > 0 || this.#appended.size > 0;
  }

  /** Whether there are buffers to put bytes behind. */
  get canGrow(): boolean {
    const { document } = this;
    return ['buffers', 'bufferViews'].every((key) => document.list(document.root, key).length > 0);
  }

  /** A buffer, for overwriting. */
  view(buffer: number): DataView {
    let view = this.#views.get(buffer);
    if (!view) {
      view = viewOf(this.document.buffer(buffer));
      this.#views.set(buffer, view);
    }
    return view;
  }

  /** Puts the data of vertices behind a buffer. @returns the index of a new buffer view of them */
  append(buffer: number, bytes: Uint8Array): number {
    const pieces = this.#appended.get(buffer) ?? [];
    const offset = this.#lengthOf(buffer) + pieces.reduce((sum, piece) => sum + padded(piece.length), 0);
    this.#appended.set(buffer, [...pieces, bytes]);
    return this.#addElement('bufferViews', {
      buffer,
      byteOffset: offset,
      byteLength: bytes.length,
      target: 34962,
    });
  }

  /** Replaces element `index` of a list of the JSON. */
  replaceElement(key: string, index: number, value: unknown): void {
    const spans = elementSpans(this.#result, memberSpan(this.#result, this.#root, key));
    this.#replacements.push({ span: spans[index], text: JSON.stringify(value) });
  }

  /** Replaces a member of element `index` of a list of the JSON, if it has it. */
  replaceMember(key: string, index: number, member: string, value: unknown): void {
    const spans = elementSpans(this.#result, memberSpan(this.#result, this.#root, key));
    const span = memberSpan(this.#result, spans[index], member);
    if (span) this.#replacements.push({ span, text: JSON.stringify(value) });
  }

  /** The copy. What its source has in files beside it comes inside, since the copy may go elsewhere. */
  finish(): Uint8Array<ArrayBuffer> {
    const elsewhere = this.document.elsewhere();
    if (!this.isTouched && elsewhere.length === 0) return this.#result;
    for (const [key, texts] of this.#newElements) {
      const end = memberSpan(this.#result, this.#root, key)![1] - 1;
      this.#replacements.push({ span: [end, end], text: texts.map((text) => `,${text}`).join('') });
    }
    for (const buffer of this.#appended.keys()) {
      const length = this.#lengthOf(buffer) + this.#tail(buffer).length;
      this.replaceMember('buffers', buffer, 'byteLength', length);
    }
    const outside = elsewhere.flatMap(({ key, index }) => (key === 'buffers' ? [index] : []));
    for (const buffer of new Set([...this.#views.keys(), ...this.#appended.keys(), ...outside])) {
      if (this.#isChunk(buffer)) continue;
      this.replaceMember('buffers', buffer, 'uri', this.#newUri(buffer));
    }
    for (const { key, index, path } of elsewhere) {
      const image = key === 'images' ? imageInside(this.document, path) : undefined;
      if (image) this.replaceMember('images', index, 'uri', image);
    }
    const json = this.#newJson();
    return this.#isGlb ? this.#glb(json) : concatenate([this.#result.subarray(0, this.#jsonSpan[0]), json]);
  }

  #addElement(key: string, value: unknown): number {
    const texts = this.#newElements.get(key) ?? [];
    this.#newElements.set(key, [...texts, JSON.stringify(value)]);
    return this.document.list(this.document.root, key).length + texts.length;
  }

  get #jsonSpan(): Span {
    return this.document.layout.json;
  }

  /** Whether a buffer is the binary chunk and not a text in the JSON. */
  #isChunk(buffer: number): boolean {
    return this.document.element('buffers', buffer, 'patch').uri === undefined;
  }

  /** Where bytes behind a buffer begin: bytes that are there without being said to be stay. */
  #lengthOf(buffer: number): number {
    const { bin } = this.document.layout;
    if (this.#isChunk(buffer) && bin) return padded(bin[1] - bin[0]);
    return padded(this.document.buffer(buffer).buffer.byteLength);
  }

  /** What is put behind a buffer, each piece to a multiple of four. */
  #tail(buffer: number): Uint8Array {
    const pieces = this.#appended.get(buffer) ?? [];
    return concatenate(
      pieces.flatMap((piece) => [piece, new Uint8Array(padded(piece.length) - piece.length)]),
    );
  }

  /** The data URI of a buffer: only its base64 part is new. One that was a file beside this one comes inside. */
  #newUri(buffer: number): string {
    const uri = String(this.document.element('buffers', buffer, 'patch').uri);
    const isInside = /^data:/i.test(uri);
    const head = isInside ? uri.slice(0, uri.indexOf(',') + 1) : 'data:application/octet-stream;base64,';
    // The buffer may be shorter than what the URI holds; bytes behind it stay.
    const whole = new Uint8Array(this.document.buffer(buffer).buffer);
    const tail = this.#tail(buffer);
    if (tail.length === 0) return head + encodeBase64(whole);
    const gap = new Uint8Array(padded(whole.length) - whole.length);
    return head + encodeBase64(concatenate([whole, gap, tail]));
  }

  #newJson(): Uint8Array<ArrayBuffer> {
    const [begin, end] = this.#jsonSpan;
    const writer = new ByteWriter(end - begin + 64 * this.#replacements.length);
    let copied = begin;
    for (const { span, text } of this.#replacements.sort((a, b) => a.span[0] - b.span[0])) {
      writer.copy(this.#result, copied, span[0]);
      const encoded = encodeUtf8(text);
      writer.copy(encoded, 0, encoded.length);
      copied = span[1];
    }
    writer.copy(this.#result, copied, end);
    return writer.take();
  }

  /** The GLB with another JSON chunk, padded with blanks to a multiple of four, and a longer binary one. */
  #glb(json: Uint8Array): Uint8Array<ArrayBuffer> {
    const source = this.#result;
    const [begin, end] = this.#jsonSpan;
    const { bin = [source.length, source.length] } = this.document.layout;
    let length = json.length;
    while (length > 0 && json[length - 1] === 32) length--;
    const text = new Uint8Array(padded(length)).fill(32);
    text.set(json.subarray(0, length));
    const chunk = [...this.#appended.keys()].find((buffer) => this.#isChunk(buffer));
    const tail = chunk === undefined ? new Uint8Array() : this.#tail(chunk);
    const gap = new Uint8Array(tail.length > 0 ? padded(bin[1] - bin[0]) - (bin[1] - bin[0]) : 0);
    const head = source.slice(0, begin);
    viewOf(head).setUint32(begin - 8, text.length, true);
    const between = source.slice(end, bin[0]);
    if (tail.length > 0) {
      viewOf(between).setUint32(between.length - 8, bin[1] - bin[0] + gap.length + tail.length, true);
    }
    const body = [text, between, source.subarray(bin[0], bin[1]), gap, tail, source.subarray(bin[1])];
    const result = concatenate([head, ...body]);
    const said = viewOf(head).getUint32(8, true);
    const grown = text.length - (end - begin) + gap.length + tail.length;
    viewOf(result).setUint32(8, said + grown, true);
    return result;
  }
}

/** The next multiple of four. */
function padded(length: number): number {
  return 4 * Math.ceil(length / 4);
}
