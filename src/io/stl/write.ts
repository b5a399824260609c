import { ByteWriter } from '../byte-writer.ts';
import { encodeUtf8, viewOf } from '../bytes.ts';
import type { Shape } from '../parsed-file.ts';
import { newellVector } from '../polygon.ts';
import { stlFacet, stlHeader } from './facet-count.ts';

/** A new binary STL, positions rounded to 32 bits. */
export function writeStlBinary({ positions, triangles }: Shape): Uint8Array<ArrayBuffer> {
  const count = triangles.length / 3;
  const bytes = new Uint8Array(stlHeader + stlFacet * count);
  bytes.set(encodeUtf8('STL written by Whittle')); // must not begin with "solid"
  const view = viewOf(bytes);
  view.setUint32(80, count, true);
  const normal = new Float64Array(3);
  for (let t = 0; t < count; t++) {
    const offset = stlHeader + stlFacet * t;
    unitNormal(positions, triangles, t, normal);
    for (let axis = 0; axis < 3; axis++) view.setFloat32(offset + 4 * axis, normal[axis], true);
    for (let i = 0; i < 9; i++) {
      const p = triangles[3 * t + Math.floor(i / 3)];
      view.setFloat32(offset + 12 + 4 * i, positions[3 * p + (i % 3)], true);
    }
  }
  return bytes;
}

/** A new ASCII STL. */
export function writeStlText({ positions, triangles }: Shape): Uint8Array<ArrayBuffer> {
  const writer = new ByteWriter(80 * triangles.length);
  const normal = new Float64Array(3);
  writer.ascii('solid whittle\n');
  for (let t = 0; 3 * t < triangles.length; t++) {
    unitNormal(positions, triangles, t, normal);
    const [x, y, z] = normal.map((value) => Math.round(value * 1e6) / 1e6 + 0);
    writer.ascii(`facet normal ${x} ${y} ${z}\nouter loop\n`);
    for (let c = 3 * t; c < 3 * t + 3; c++) {
      const i = 3 * triangles[c];
      writer.ascii(`vertex ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}\n`);
    }
    writer.ascii('endloop\nendfacet\n');
  }
  writer.ascii('endsolid whittle\n');
  return writer.take();
}

/** Zero for a triangle without area. */
function unitNormal(positions: Float64Array, triangles: Uint32Array, t: number, into: Float64Array): void {
  newellVector(positions, triangles, 3 * t, 3 * t + 3, into);
  const length = Math.hypot(into[0], into[1], into[2]);
  for (let axis = 0; axis < 3; axis++) into[axis] = length > 0 ? into[axis] / length : 0;
}
