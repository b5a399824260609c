import { viewOf } from '../bytes.ts';
import { fitsFloat32, unfitPosition } from '../fit.ts';
import { newNormals } from '../normals.ts';
import { refusal } from '../refuse.ts';
import { hasMoved } from '../text-patch.ts';
import { Accessor } from './accessor.ts';
import { GltfAssembly } from './assembly.ts';
import { apply3, applyTransposed3, invert3, linearPart } from './matrix.ts';
import type { GltfFile, GltfNormals, GltfPart } from './scan.ts';

/**
 * Gives an asset back with other positions, normals and tangents, rounded to the numbers they are stored as, and with the
 * `min` and `max` of their accessors. Other JSON, chunks and buffers stay byte for byte. Positions that are whole numbers get a
 * buffer view of their own with decimal ones, in the frame that they were in.
 *
 * @throws unsupported-file if changed positions stand under a transform that flattens them, or in a file without buffers
 */
export function patchGltf(
  _source: Uint8Array,
  file: GltfFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  return new GltfPatch(file, positions).run();
}

class GltfPatch {
  readonly #file: GltfFile;
  readonly #after: Float64Array;
  readonly #assembly: GltfAssembly;
  /** Accessors that were written to in place. */
  readonly #touched = new Set<number>();

  constructor(file: GltfFile, after: Float64Array) {
    this.#file = file;
    this.#after = after;
    this.#assembly = new GltfAssembly(file.document);
  }

  run(): Uint8Array<ArrayBuffer> {
    for (const part of this.#file.parts) this.#patchPositions(part);
    if (!this.#assembly.isTouched) return this.#assembly.finish();
    if (this.#file.normals.length > 0) this.#patchNormals();
    for (const index of this.#touched) this.#newBounds(index);
    return this.#assembly.finish();
  }

  #patchPositions(part: GltfPart): void {
    const { accessor, first, toWorld } = part;
    const before = this.#file.positions;
    const after = this.#after;
    const inverse = invert3(linearPart(toWorld));
    const local = accessor.read();
    const isStored = accessor.isFloat && accessor.isWhole;
    const move = new Float64Array(3);
    let hasNew = false;
    for (let v = 0; v < accessor.count; v++) {
      const p = first + v;
      if (!hasMoved(before, after, p)) continue;
      if (!inverse || (!isStored && !this.#assembly.canGrow)) throw this.#cannotHold(accessor, !inverse);
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
      const view = isStored ? this.#assembly.view(accessor.bufferOf(v)) : undefined;
      for (let axis = 0; axis < 3; axis++) {
        const value = local[3 * v + axis] + move[axis];
        if (!fitsFloat32(value)) throw unfitPosition(this.#file.document.name, p, after[i + axis]);
        if (view) accessor.set(view, v, axis, value);
        else local[3 * v + axis] = value;
      }
      hasNew = true;
    }
    if (hasNew && isStored) this.#touched.add(accessor.index);
    else if (hasNew) this.#storeAnew(accessor, local);
  }

  /** Gives an accessor of whole numbers, or of numbers that are not stored, a buffer view of decimal ones of its own. */
  #storeAnew(accessor: Accessor, values: Float64Array): void {
    const floats = Float32Array.from(values);
    const bytes = new Uint8Array(floats.buffer);
    const view = viewOf(bytes);
    for (let i = 0; i < floats.length; i++) view.setFloat32(4 * i, floats[i], true);
    const { normalized, sparse, byteOffset, ...rest } = this.#file.document.element(
      'accessors',
      accessor.index,
      'patch',
    );
    const bufferView = this.#assembly.append(accessor.anyBuffer, bytes);
    this.#assembly.replaceElement('accessors', accessor.index, {
      ...rest,
      ...{ bufferView, componentType: 5126, ...boundsOf(floats, accessor.components) },
    });
  }

  #cannotHold(accessor: Accessor, isFlat: boolean): Error {
    const why = isFlat
      ? 'a node scales its positions to nothing; apply its transform first, or save as .obj instead.'
      : 'its positions are not stored at all; save as .obj instead.';
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
      const view = this.#assembly.view(accessor.bufferOf(v));
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
    const view = this.#assembly.view(tangents.bufferOf(v));
    for (let axis = 0; axis < 3; axis++) tangents.set(view, v, axis, tangent[axis]);
    this.#touched.add(tangents.index);
  }

  /** New bounds of an accessor that was written to, where they are others. */
  #newBounds(index: number): void {
    const { document } = this.#assembly;
    const accessor = new Accessor(document, index, 'patch');
    const bounds = boundsOf(accessor.read(), accessor.components);
    const json = document.element('accessors', index, 'patch');
    for (const key of ['min', 'max'] as const) {
      const given = json[key];
      const isSame = Array.isArray(given) && bounds[key].every((value, i) => value === given[i]);
      if (!isSame) this.#assembly.replaceMember('accessors', index, key, bounds[key]);
    }
  }
}

function boundsOf(values: Float64Array | Float32Array, step: number): { min: number[]; max: number[] } {
  const min = new Array<number>(step).fill(Infinity);
  const max = new Array<number>(step).fill(-Infinity);
  for (let i = 0; i < values.length; i++) {
    // What is no number, of a vertex that no face uses, is no bound.
    if (values[i] < min[i % step]) min[i % step] = values[i];
    if (values[i] > max[i % step]) max[i % step] = values[i];
  }
  return { min, max };
}

function normalize(vector: Float64Array): boolean {
  const length = Math.hypot(vector[0], vector[1], vector[2]);
  if (!(length > 0)) return false;
  for (let axis = 0; axis < 3; axis++) vector[axis] /= length;
  return true;
}
