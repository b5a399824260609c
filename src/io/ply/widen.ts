import { ByteWriter } from '../byte-writer.ts';
import { viewOf } from '../bytes.ts';
import { kindSize, type NumberKind, type PlyProperty } from './header.ts';
import { PlyRows } from './rows.ts';
import type { PlyFile } from './scan.ts';

/** A PLY file whose positions are decimal numbers. */
export interface WidenedPly {
  readonly source: Uint8Array;
  /** Those of the vertices. */
  readonly properties: readonly PlyProperty[];
  /** #P byte offsets at each vertex. */
  readonly rowOffsets: Uint32Array;
}

/** Up to here a `float` keeps an eighth of a unit. */
const largestInFloat = 2 ** 20;

/**
 * Makes room in a file for decimal numbers where its positions are whole ones: the header names another type, and in a binary
 * file each row grows. All other bytes stay.
 *
 * @param axes the properties x, y and z
 */
export function widenedPly(source: Uint8Array, file: PlyFile, axes: readonly number[]): WidenedPly {
  const { properties } = file.vertex;
  const { rowOffsets } = file;
  const narrow = axes.filter((column) => !properties[column].kind.startsWith('float')).sort((a, b) => a - b);
  if (narrow.length === 0) return { source, properties, rowOffsets };
  const isLarge = file.positions.some((value) => Math.abs(value) >= largestInFloat);
  const kind = isLarge ? 'float64' : 'float32';
  const writer = new ByteWriter(source.length + narrow.length * 8 * rowOffsets.length);
  let copied = 0;
  for (const { kindSpan } of narrow.map((column) => properties[column])) {
    writer.copy(source, copied, kindSpan[0]);
    writer.ascii(isLarge ? 'double' : 'float');
    copied = kindSpan[1];
  }
  const wide = properties.map((property, i) =>
    narrow.includes(i) ? { ...property, kind } : property,
  ) as PlyProperty[];
  if (file.header.encoding === 'ascii') {
    const grown = writer.length - copied;
    writer.copy(source, copied, source.length);
    return { source: writer.take(), properties: wide, rowOffsets: rowOffsets.map((at) => at + grown) };
  }
  const rows = widenRows(source, file, narrow, kind, writer, copied);
  writer.copy(source, file.rowsEnd, source.length);
  return { source: writer.take(), properties: wide, rowOffsets: rows };
}

/** Copies what stands before the vertices and then these, with wider numbers in place of the narrow ones. */
function widenRows(
  source: Uint8Array,
  { vertex, rowOffsets, rowsEnd, header, positions }: PlyFile,
  narrow: readonly number[],
  kind: NumberKind,
  writer: ByteWriter,
  from: number,
): Uint32Array {
  const little = header.encoding === 'little';
  const rows = new PlyRows(vertex.properties, narrow);
  const result = new Uint32Array(rowOffsets.length);
  const scratch = new Uint8Array(kindSize[kind]);
  const axisOf = narrow.map((column) => 'xyz'.indexOf(vertex.properties[column].name));
  let copied = from;
  for (let p = 0; p < rowOffsets.length; p++) {
    writer.copy(source, copied, rowOffsets[p]);
    result[p] = writer.length;
    copied = rowOffsets[p];
    rows.bytes(source, rowOffsets[p], little).forEach((at, i) => {
      writer.copy(source, copied, at);
      const value = positions[3 * p + axisOf[i]];
      if (kind === 'float64') viewOf(scratch).setFloat64(0, value, little);
      else viewOf(scratch).setFloat32(0, value, little);
      writer.copy(scratch, 0, scratch.length);
      copied = at + kindSize[vertex.properties[narrow[i]].kind];
    });
  }
  writer.copy(source, copied, rowsEnd);
  return result;
}
