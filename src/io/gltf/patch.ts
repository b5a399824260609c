import { ByteWriter } from '../byte-writer.ts';
import { encodeUtf8, viewOf } from '../bytes.ts';
import { fitsFloat32, unfitPosition } from '../fit.ts';
import { newNormals } from '../normals.ts';
import { refusal } from '../refuse.ts';
import { hasMoved } from '../text-patch.ts';
import { Accessor } from './accessor.ts';
import { encodeBase64 } from './base64.ts';
import { GltfDocument } from './document.ts';
import { elementSpans, memberSpan, type Span, valueSpan } from './json-spans.ts';
import { apply3, applyTransposed3, invert3, linearPart } from './matrix.ts';
import type { GltfFile, GltfNormals, GltfPart } from './scan.ts';

/**
 * Gives an asset back with other positions, normals and tangents, rounded to the numbers they are stored as, and with the
 * `min` and `max` of their accessors. Other JSON, chunks and buffers stay byte for byte.
 *
 * @throws unsupported-file if changed positions are stored as whole numbers, or under a transform that flattens them
 */
export function patchGltf(
  source: Uint8Array,
  file: GltfFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  return new GltfPatch(new Uint8Array(source), file, positions).run();
}

interface Replacement {
  readonly span: Span;
  readonly text: string;
}

class GltfPatch {
  readonly #result: Uint8Array<ArrayBuffer>;
  readonly #file: GltfFile;
  readonly #after: Float64Array;
  /** A document over the copy; its buffers are what is written to. */
  readonly #target: GltfDocument;
  readonly #views = new Map<number, DataView>();
  readonly #touched = new Set<number>();

  constructor(result: Uint8Array<ArrayBuffer>, file: GltfFile, after: Float64Array) {
    this.#result = result;
    this.#file = file;
    this.#after = after;
    this.#target = new GltfDocument(
      result,
      file.document.name,
      file.document.layout.bin !== undefined || isGlb(result),
    );
  }

  run(): Uint8Array<ArrayBuffer> {
    for (const part of this.#file.parts) this.#patchPositions(part);
    if (this.#views.size === 0) return this.#result;
    if (this.#file.normals.length > 0) this.#patchNormals();
    return this.#withJson(this.#jsonReplacements());
  }

  #patchPositions(part: GltfPart): void {
    const { accessor, first, toWorld } = part;
    const before = this.#file.positions;
    const after = this.#after;
    const inverse = invert3(linearPart(toWorld));
    const local = accessor.read();
    const move = new Float64Array(3);
    for (let v = 0; v < accessor.count; v++) {
      const p = first + v;
      if (!hasMoved(before, after, p)) continue;
      if (!accessor.isFloat || !inverse || accessor.bufferOf(v) < 0)
        throw this.#cannotHold(accessor, !inverse);
      const i = 3 * p;
      // By difference, so that a coordinate that has not moved keeps its bits.
      apply3(
        inverse,
        after[i] - before[i],
        after[i + 1] - before[i + 1],
        after[i + 2] - before[i + 2],
        move,
        0,
      );
      const view = this.#view(accessor, v);
      for (let axis = 0; axis < 3; axis++) {
        const value = local[3 * v + axis] + move[axis];
        if (!fitsFloat32(value)) throw unfitPosition(this.#file.document.name, p, after[i + axis]);
        accessor.set(view, v, axis, value);
      }
      this.#touched.add(accessor.index);
    }
  }

  #cannotHold(accessor: Accessor, isFlat: boolean): Error {
    const why = isFlat
      ? 'a node scales its positions to nothing; apply its transform first, or save as .obj instead.'
      : 'its positions are stored as whole numbers or not at all, which cannot hold the new shape; run "gltf-transform dequantize" on the file first, or save as .obj instead.';
    return refusal('unsupported-file', this.#file.document.name, `accessor ${accessor.index}`, why);
  }

  #patchNormals(): void {
    const { faces, positions, normals, normalOfCorner, normalParts } = this.#file;
    const fresh = newNormals(faces, positions, this.#after, { values: normals, ofCorner: normalOfCorner });
    for (const part of normalParts) this.#patchNormalPart(part, fresh);
  }

  #patchNormalPart({ accessor, first, toWorld, tangents }: GltfNormals, fresh: Float64Array): void {
    const linear = linearPart(toWorld);
    const normal = new Float64Array(3);
    const tangentValues = tangents?.read();
    for (let v = 0; v < accessor.count; v++) {
      const i = 3 * (first + v);
      if (Number.isNaN(fresh[i]) || accessor.bufferOf(v) < 0) continue;
      applyTransposed3(linear, fresh[i], fresh[i + 1], fresh[i + 2], normal, 0);
      if (!normalize(normal)) continue;
      const view = this.#view(accessor, v);
      for (let axis = 0; axis < 3; axis++) accessor.set(view, v, axis, normal[axis]);
      this.#touched.add(accessor.index);
      if (tangents && tangentValues) this.#patchTangent(tangents, v, tangentValues, normal);
    }
  }

  /** The part of the old tangent that is at right angles to the new normal; its handedness stays. */
  #patchTangent(tangents: Accessor, v: number, values: Float64Array, normal: Float64Array): void {
    if (tangents.bufferOf(v) < 0) return;
    const tangent = values.slice(4 * v, 4 * v + 3);
    const along = tangent[0] * normal[0] + tangent[1] * normal[1] + tangent[2] * normal[2];
    for (let axis = 0; axis < 3; axis++) tangent[axis] -= along * normal[axis];
    if (!normalize(tangent)) return;
    const view = this.#view(tangents, v);
    for (let axis = 0; axis < 3; axis++) tangents.set(view, v, axis, tangent[axis]);
    this.#touched.add(tangents.index);
  }

  #view(accessor: Accessor, element: number): DataView {
    const buffer = accessor.bufferOf(element);
    let view = this.#views.get(buffer);
    if (!view) {
      view = viewOf(this.#target.buffer(buffer));
      this.#views.set(buffer, view);
    }
    return view;
  }

  /** New bounds of the accessors that were written to, and new text of the buffers that are in the JSON. */
  #jsonReplacements(): Replacement[] {
    const bytes = this.#result;
    const root = valueSpan(bytes, this.#target.layout.json[0]);
    const replacements: Replacement[] = [];
    const accessors = elementSpans(bytes, memberSpan(bytes, root, 'accessors'));
    for (const index of this.#touched) replacements.push(...this.#newBounds(index, accessors[index]));
    const buffers = elementSpans(bytes, memberSpan(bytes, root, 'buffers'));
    for (const index of this.#views.keys()) {
      const span = memberSpan(bytes, buffers[index], 'uri');
      if (span) replacements.push({ span, text: this.#newUri(index) });
    }
    return replacements.sort((a, b) => a.span[0] - b.span[0]);
  }

  #newBounds(index: number, accessorSpan: Span): Replacement[] {
    const accessor = new Accessor(this.#target, index, 'patch');
    const step = accessor.components;
    const values = accessor.read();
    const bounds = {
      min: new Array<number>(step).fill(Infinity),
      max: new Array<number>(step).fill(-Infinity),
    };
    for (let i = 0; i < values.length; i++) {
      bounds.min[i % step] = Math.min(bounds.min[i % step], values[i]);
      bounds.max[i % step] = Math.max(bounds.max[i % step], values[i]);
    }
    const json = this.#target.element('accessors', index, 'patch');
    return (['min', 'max'] as const).flatMap((key) => {
      const span = memberSpan(this.#result, accessorSpan, key);
      const given = json[key];
      if (!span || (Array.isArray(given) && bounds[key].every((value, i) => value === given[i]))) return [];
      return [{ span, text: JSON.stringify(bounds[key]) }];
    });
  }

  /** The data URI of a patched buffer: only its base64 part is new. */
  #newUri(index: number): string {
    const uri = String(this.#target.element('buffers', index, 'patch').uri);
    const head = uri.slice(0, uri.indexOf(',') + 1);
    const view = this.#views.get(index)!;
    // The view may be shorter than what the URI holds; bytes behind it stay.
    return JSON.stringify(head + encodeBase64(new Uint8Array(view.buffer)));
  }

  #withJson(replacements: readonly Replacement[]): Uint8Array<ArrayBuffer> {
    const source = this.#result;
    if (replacements.length === 0) return source;
    const [begin, end] = this.#target.layout.json;
    const writer = new ByteWriter(end - begin + 64 * replacements.length);
    let copied = begin;
    for (const { span, text } of replacements) {
      writer.copy(source, copied, span[0]);
      const encoded = encodeUtf8(text);
      writer.copy(encoded, 0, encoded.length);
      copied = span[1];
    }
    writer.copy(source, copied, end);
    const json = writer.take();
    return isGlb(source)
      ? withJsonChunk(source, begin, end, json)
      : concatenate([source.subarray(0, begin), json]);
  }
}

/** A GLB with another JSON chunk, padded with blanks to a multiple of four. */
function withJsonChunk(
  source: Uint8Array,
  begin: number,
  end: number,
  json: Uint8Array,
): Uint8Array<ArrayBuffer> {
  let length = json.length;
  while (length > 0 && json[length - 1] === 32) length--;
  const padded = new Uint8Array(4 * Math.ceil(length / 4)).fill(32);
  padded.set(json.subarray(0, length));
  const result = concatenate([source.subarray(0, begin), padded, source.subarray(end)]);
  const view = viewOf(result);
  view.setUint32(8, view.getUint32(8, true) + padded.length - (end - begin), true);
  view.setUint32(begin - 8, padded.length, true);
  return result;
}

function concatenate(pieces: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const result = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    result.set(piece, at);
    at += piece.length;
  }
  return result;
}

/** "glTF". */
function isGlb(bytes: Uint8Array): boolean {
  return bytes[0] === 0x67 && bytes[1] === 0x6c && bytes[2] === 0x54 && bytes[3] === 0x46;
}

function normalize(vector: Float64Array): boolean {
  const length = Math.hypot(vector[0], vector[1], vector[2]);
  if (!(length > 0)) return false;
  for (let axis = 0; axis < 3; axis++) vector[axis] /= length;
  return true;
}
