import { viewOf } from '../bytes.ts';
import { fitsFloat32, unfitPosition } from '../fit.ts';
import { newNormals } from '../normals.ts';
import { hasMoved, normalTexts, positionTexts, TextPatch } from '../text-patch.ts';
import type { PlyProperty } from './header.ts';
import { PlyRows } from './rows.ts';
import { type PlyFile, plyNormal, plyPosition } from './scan.ts';
import { widenedPly } from './widen.ts';

/**
 * Gives a PLY file back with other positions and vertex normals; every other property and element stays. `float` positions
 * of a binary file are rounded to 32 bits. Positions that were whole numbers become `float`, or `double` where they are large.
 *
 * @throws not-finite if a position does not fit
 */
export function patchPly(
  source: Uint8Array,
  file: PlyFile,
  positions: Float64Array,
  name: string,
): Uint8Array<ArrayBuffer> {
  if (!file.positions.some((value, i) => value !== positions[i])) return new Uint8Array(source);
  const axes = plyPosition.map((axis) => columnOf(file, axis));
  const widened = widenedPly(source, file, axes);
  const normals = newPlyNormals(file, positions);
  const columns = normals ? [...axes, ...plyNormal.map((axis) => columnOf(file, axis))] : axes;
  const patch = { ...widened, before: file, positions, normals, columns, name };
  return file.header.encoding === 'ascii' ? patchText(patch) : patchBinary(patch);
}

interface Patch {
  /** The bytes, types and places that are patched; those of the file where its numbers are decimal ones. */
  readonly source: Uint8Array;
  readonly properties: readonly PlyProperty[];
  readonly rowOffsets: Uint32Array;
  readonly before: PlyFile;
  readonly positions: Float64Array;
  readonly normals: Float64Array | undefined;
  /** The properties of positions and, if there are any, of normals. */
  readonly columns: readonly number[];
  readonly name: string;
}

/** Normals stored as whole numbers are left alone: what their unit is, the file does not say. */
function newPlyNormals(file: PlyFile, positions: Float64Array): Float64Array | undefined {
  const isFloat = (axis: string) => file.vertex.properties[columnOf(file, axis)].kind.startsWith('float');
  if (file.normals.length === 0 || !plyNormal.every(isFloat)) return undefined;
  const stored = { values: file.normals, ofCorner: file.faces.corners };
  return newNormals(file.faces, file.positions, positions, stored);
}

/** Index of a property among the vertex's properties. */
function columnOf({ vertex }: PlyFile, property: string): number {
  return vertex.properties.findLastIndex(({ name, countKind }) => name === property && !countKind);
}

/** Slots (x, y, z, and those of the normal) in the order of their properties. */
function inOrder(columns: readonly number[]): number[] {
  return columns.map((_, slot) => slot).sort((a, b) => columns[a] - columns[b]);
}

function patchText(all: Patch): Uint8Array<ArrayBuffer> {
  const { source, properties, rowOffsets, before, positions, normals, columns } = all;
  const patch = new TextPatch(source);
  const order = inOrder(columns);
  const rows = new PlyRows(
    properties,
    order.map((slot) => columns[slot]),
  );
  for (let p = 0; p < rowOffsets.length; p++) {
    const turned = normals !== undefined && !Number.isNaN(normals[3 * p]);
    if (!turned && !hasMoved(before.positions, positions, p)) continue;
    const texts = positionTexts(before.positions, positions, p);
    if (turned) texts.push(...normalTexts(before.normals, normals, p));
    patch.row(
      rowOffsets[p],
      rows.words(source, rowOffsets[p]),
      order.map((slot) => texts[slot]),
    );
  }
  return patch.take();
}

function patchBinary(all: Patch): Uint8Array<ArrayBuffer> {
  const { source, properties, rowOffsets, before, positions, normals, columns, name } = all;
  const result = new Uint8Array(source);
  const view = viewOf(result);
  const little = before.header.encoding === 'little';
  const order = inOrder(columns);
  const slotKinds = columns.map((column) => properties[column].kind);
  const rows = new PlyRows(
    properties,
    order.map((slot) => columns[slot]),
  );
  for (let p = 0; p < rowOffsets.length; p++) {
    const turned = normals !== undefined && !Number.isNaN(normals[3 * p]);
    if (!turned && !hasMoved(before.positions, positions, p)) continue;
    const places = rows.bytes(source, rowOffsets[p], little);
    for (let i = 0; i < order.length; i++) {
      const slot = order[i];
      const at = 3 * p + (slot % 3);
      const value = slot < 3 ? positions[at] : normals![at];
      if (slot < 3 ? value === before.positions[at] : !turned) continue;
      if (slotKinds[slot] === 'float64') view.setFloat64(places[i], value, little);
      else if (fitsFloat32(value)) view.setFloat32(places[i], value, little);
      else throw unfitPosition(name, p, value);
    }
  }
  return result;
}
