import { viewOf } from '../bytes.ts';
import { fitsFloat32, unfitPosition } from '../fit.ts';
import { newNormals } from '../normals.ts';
import { refusal } from '../refuse.ts';
import { hasMoved, normalTexts, positionTexts, TextPatch } from '../text-patch.ts';
import { kindSize, type PlyProperty } from './header.ts';
import { type PlyFile, plyNormal, plyPosition } from './scan.ts';

/**
 * Gives a PLY file back with other positions and vertex normals; every other property and element stays. `float` positions
 * of a binary file are rounded to 32 bits.
 *
 * @throws unsupported-file if positions are stored as whole numbers, or behind a list, and have changed
 */
export function patchPly(
  source: Uint8Array,
  file: PlyFile,
  positions: Float64Array,
  name: string,
): Uint8Array<ArrayBuffer> {
  if (!anyMoved(file.positions, positions)) return new Uint8Array(source);
  const columns = plyPosition.map((axis) => columnOf(file, axis, name));
  const normals = newPlyNormals(file, positions);
  if (normals) columns.push(...plyNormal.map((axis) => columnOf(file, axis, name)));
  return file.header.encoding === 'ascii'
    ? patchText(source, file, positions, normals, columns)
    : patchBinary(source, file, positions, normals, columns, name);
}

function anyMoved(before: Float64Array, after: Float64Array): boolean {
  return before.some((value, i) => value !== after[i]);
}

/** Normals stored as whole numbers are left alone: what their unit is, the file does not say. */
function newPlyNormals(file: PlyFile, positions: Float64Array): Float64Array | undefined {
  const isFloat = (axis: string) => propertyOf(file, axis)?.kind.startsWith('float') === true;
  if (file.normals.length === 0 || !plyNormal.every(isFloat)) return undefined;
  const stored = { values: file.normals, ofCorner: file.faces.corners };
  return newNormals(file.faces, file.positions, positions, stored);
}

function propertyOf(file: PlyFile, property: string): PlyProperty | undefined {
  return file.vertex.properties.findLast((candidate) => candidate.name === property && !candidate.countKind);
}

/** Index of a property among the vertex's properties. */
function columnOf(file: PlyFile, property: string, name: string): number {
  const { properties } = file.vertex;
  const column = properties.indexOf(propertyOf(file, property)!);
  const isFloat = properties[column].kind.startsWith('float');
  if (isFloat && !properties.slice(0, column).some((before) => before.countKind)) return column;
  const why = isFloat ? 'behind a list' : 'as whole numbers';
  const sentence = `positions are stored ${why}, which cannot hold the new shape; save as .obj or .glb instead.`;
  throw refusal('unsupported-file', name, `property "${property}"`, sentence);
}

function patchText(
  source: Uint8Array,
  file: PlyFile,
  positions: Float64Array,
  normals: Float64Array | undefined,
  columns: readonly number[],
): Uint8Array<ArrayBuffer> {
  const patch = new TextPatch(source);
  const order = columns.map((_, slot) => slot).sort((a, b) => columns[a] - columns[b]);
  const sorted = order.map((slot) => columns[slot]);
  for (let p = 0; p < file.rowOffsets.length; p++) {
    const turned = normals !== undefined && !Number.isNaN(normals[3 * p]);
    if (!turned && !hasMoved(file.positions, positions, p)) continue;
    const texts = positionTexts(file.positions, positions, p);
    if (turned) texts.push(...normalTexts(file.normals, normals, p));
    patch.row(
      file.rowOffsets[p],
      sorted,
      order.map((slot) => texts[slot]),
    );
  }
  return patch.take();
}

function patchBinary(
  source: Uint8Array,
  file: PlyFile,
  positions: Float64Array,
  normals: Float64Array | undefined,
  columns: readonly number[],
  name: string,
): Uint8Array<ArrayBuffer> {
  const result = new Uint8Array(source);
  const view = viewOf(result);
  const { properties } = file.vertex;
  const little = file.header.encoding === 'little';
  const set = (slot: number, row: number, value: number) => {
    const at = row + byteOffset(properties, columns[slot]);
    if (properties[columns[slot]].kind === 'float64') view.setFloat64(at, value, little);
    else if (fitsFloat32(value)) view.setFloat32(at, value, little);
    else throw unfitPosition(name, file.rowOffsets.indexOf(row), value);
  };
  for (let p = 0; p < file.rowOffsets.length; p++) {
    const row = file.rowOffsets[p];
    for (let axis = 0; axis < 3; axis++) {
      const i = 3 * p + axis;
      if (positions[i] !== file.positions[i]) set(axis, row, positions[i]);
      if (normals && !Number.isNaN(normals[i])) set(3 + axis, row, normals[i]);
    }
  }
  return result;
}

/** Bytes before a property, none of which is a list. */
function byteOffset(properties: readonly PlyProperty[], column: number): number {
  let offset = 0;
  for (let i = 0; i < column; i++) offset += kindSize[properties[i].kind];
  return offset;
}
