import { ByteWriter } from '../byte-writer.ts';
import { encodeUtf8, viewOf } from '../bytes.ts';
import { byteFromLinear } from '../color.ts';
import type { Shape } from '../parsed-file.ts';

/**
 * A new binary PLY (little endian): double positions, so that nothing is lost, colours as bytes, polygons, and texture coordinates
 * as a list of each face, which is where MeshLab has them.
 */
export function writePlyBinary(shape: Shape): Uint8Array<ArrayBuffer> {
  const { positions, colors, faces, uvs } = shape;
  const header = encodeUtf8(plyHeader(shape, 'binary_little_endian'));
  const vertexCount = positions.length / 3;
  const faceCount = faces.start.length - 1;
  const rowSize = colors ? 27 : 24;
  const uvSize = uvs ? faceCount + 8 * faces.corners.length : 0;
  const bodySize = rowSize * vertexCount + 4 * faceCount + 4 * faces.corners.length + uvSize;
  const bytes = new Uint8Array(header.length + bodySize);
  bytes.set(header);
  const view = viewOf(bytes);
  let at = header.length;
  for (let v = 0; v < vertexCount; v++, at += rowSize) {
    for (let axis = 0; axis < 3; axis++) {
      view.setFloat64(at + 8 * axis, positions[3 * v + axis], true);
      if (colors) bytes[at + 24 + axis] = byteFromLinear(colors[3 * v + axis]);
    }
  }
  for (let f = 0; f < faceCount; f++) {
    view.setUint32(at, faces.start[f + 1] - faces.start[f], true);
    at += 4;
    for (let c = faces.start[f]; c < faces.start[f + 1]; c++, at += 4)
      view.setInt32(at, faces.corners[c], true);
    const list = uvs ? uvsOfFace(shape, uvs, f) : [];
    if (uvs) bytes[at++] = list.length;
    for (let i = 0; i < list.length; i++, at += 4) view.setFloat32(at, list[i], true);
  }
  return bytes.slice(0, at);
}

/** A new PLY in text. */
export function writePlyText(shape: Shape): Uint8Array<ArrayBuffer> {
  const { positions, colors, faces, uvs } = shape;
  const writer = new ByteWriter(12 * positions.length);
  writer.ascii(plyHeader(shape, 'ascii'));
  for (let i = 0; i < positions.length; i += 3) {
    writer.ascii(`${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
    if (colors) for (let k = i; k < i + 3; k++) writer.ascii(` ${byteFromLinear(colors[k])}`);
    writer.ascii('\n');
  }
  for (let f = 0; f + 1 < faces.start.length; f++) {
    writer.ascii(String(faces.start[f + 1] - faces.start[f]));
    for (let c = faces.start[f]; c < faces.start[f + 1]; c++) writer.ascii(` ${faces.corners[c]}`);
    if (uvs) {
      const list = uvsOfFace(shape, uvs, f);
      writer.ascii([list.length, ...list].map((value) => ` ${value}`).join(''));
    }
    writer.ascii('\n');
  }
  return writer.take();
}

/** u and v of each corner; none where one has none, or where they are more than a list of bytes counts. */
function uvsOfFace({ faces }: Shape, uvs: Float32Array, f: number): readonly number[] {
  const list = uvs.subarray(2 * faces.start[f], 2 * faces.start[f + 1]);
  return list.length > 255 || list.some(Number.isNaN) ? [] : [...list];
}

function plyHeader({ positions, colors, faces, uvs }: Shape, format: string): string {
  const lines = ['ply', `format ${format} 1.0`, 'comment written by Whittle'];
  lines.push(`element vertex ${positions.length / 3}`);
  lines.push('property double x', 'property double y', 'property double z');
  if (colors) lines.push('property uchar red', 'property uchar green', 'property uchar blue');
  lines.push(
    `element face ${faces.start.length - 1}`,
    'property list uint int vertex_indices',
    ...(uvs ? ['property list uchar float texcoord'] : []),
    'end_header',
    '',
  );
  return lines.join('\n');
}
