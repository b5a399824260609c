import { ByteWriter } from '../byte-writer.ts';
import { apply3, identity, invert3, linearPart, sameMatrix } from '../gltf/matrix.ts';
import { refusal } from '../refuse.ts';
import { hasMoved } from '../text-patch.ts';
import { repackZip } from '../zip.ts';
import type { Model } from './model.ts';
import type { ThreeMfFile, ThreeMfPart } from './scan.ts';

/**
 * Gives a 3MF back with other positions: the numbers of vertices in its model files, each that keeps its value as it is. All other
 * files of the archive stay packed as they are.
 *
 * @throws unsupported-file if changed positions stand under a transform that flattens them
 */
export function patch3mf(
  source: Uint8Array,
  file: ThreeMfFile,
  positions: Float64Array,
  name: string,
): Uint8Array<ArrayBuffer> {
  const contents = new Map<string, Uint8Array>();
  for (const model of new Set(file.parts.map((part) => part.model))) {
    const patched = patchModel(model, file, positions, name);
    if (patched) contents.set(model.path, patched);
  }
  return contents.size === 0 ? new Uint8Array(source) : repackZip(file.entries, contents);
}

/** Undefined where nothing has moved. */
function patchModel(
  model: Model,
  file: ThreeMfFile,
  positions: Float64Array,
  name: string,
): Uint8Array | undefined {
  const { bytes } = model;
  const writer = new ByteWriter(bytes.length + (bytes.length >> 2));
  let copied = 0;
  // In the order of the file, which the parts need not have.
  for (const object of model.objects.values()) {
    const part = file.parts.find((candidate) => candidate.object === object);
    if (!part) continue;
    const offsets = object.offsets.take();
    forEachNew(part, file.positions, positions, name, (i, value) => {
      writer.copy(bytes, copied, offsets[i]);
      writer.ascii(String(value));
      copied = offsets[i];
      while (bytes[copied] !== 34 && bytes[copied] !== 39) copied++;
    });
  }
  if (copied === 0) return undefined;
  writer.copy(bytes, copied, bytes.length);
  return writer.take();
}

/** Calls back with each coordinate of a part that changes, by its place in the object, in the object's own frame. */
function forEachNew(
  { object, first, toWorld, model }: ThreeMfPart,
  before: Float64Array,
  after: Float64Array,
  name: string,
  set: (i: number, value: number) => void,
): void {
  const local = object.positions.take();
  const isAtHome = sameMatrix(toWorld, identity);
  const inverse = invert3(linearPart(toWorld));
  const move = new Float64Array(3);
  for (let v = 0; 3 * v < local.length; v++) {
    const p = first + v;
    if (!hasMoved(before, after, p)) continue;
    if (!inverse) {
      const why = 'a transform scales it to nothing; save as .stl instead.';
      throw refusal('unsupported-file', name, `${model.path}, object ${object.id}`, why);
    }
    const i = 3 * p;
    const [x, y, z] = [0, 1, 2].map((axis) => after[i + axis] - before[i + axis]);
    apply3(inverse, x, y, z, move, 0);
    for (let axis = 0; axis < 3; axis++) {
      const value = isAtHome ? after[i + axis] : local[3 * v + axis] + move[axis];
      if (value !== local[3 * v + axis]) set(3 * v + axis, value);
    }
  }
}
