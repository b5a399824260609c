import { encodeUtf8, viewOf } from '../bytes.ts';
import type { Shape } from '../parsed-file.ts';
import { encodeBase64 } from './base64.ts';

/** A new GLB: one mesh, positions rounded to 32 bits, colours if there are any. Without normals, viewers shade it flat. */
export function writeGlb(shape: Shape): Uint8Array<ArrayBuffer> {
  const bin = binaryPart(shape);
  const json = encodeUtf8(JSON.stringify(jsonPart(shape, bin)));
  const jsonLength = 4 * Math.ceil(json.length / 4);
  const result = new Uint8Array(12 + 8 + jsonLength + 8 + bin.length);
  const view = viewOf(result);
  view.setUint32(0, 0x46546c67, true); // "glTF"
  view.setUint32(4, 2, true);
  view.setUint32(8, result.length, true);
  view.setUint32(12, jsonLength, true);
  view.setUint32(16, 0x4e4f534a, true); // "JSON"
  result.fill(32, 20, 20 + jsonLength);
  result.set(json, 20);
  view.setUint32(20 + jsonLength, bin.length, true);
  view.setUint32(24 + jsonLength, 0x004e4942, true); // "BIN"
  result.set(bin, 28 + jsonLength);
  return result;
}

/** A new glTF as one JSON file with its data inside: what `writeGlb` makes, in text. */
export function writeGltf(shape: Shape): Uint8Array<ArrayBuffer> {
  const bin = binaryPart(shape);
  const uri = `data:application/octet-stream;base64,${encodeBase64(bin)}`;
  return encodeUtf8(JSON.stringify(jsonPart(shape, bin, uri)));
}

/** Indices, positions, colours, one after the other. */
function binaryPart({ positions, triangles, colors }: Shape): Uint8Array<ArrayBuffer> {
  const words = triangles.length + positions.length + (colors?.length ?? 0);
  const bytes = new Uint8Array(4 * words);
  const view = viewOf(bytes);
  let at = 0;
  for (const index of triangles) {
    view.setUint32(at, index, true);
    at += 4;
  }
  for (const list of colors ? [positions, colors] : [positions]) {
    for (const value of list) {
      view.setFloat32(at, value, true);
      at += 4;
    }
  }
  return bytes;
}

function jsonPart(shape: Shape, bin: Uint8Array, uri?: string): object {
  const { positions, triangles, colors } = shape;
  const lengths = [4 * triangles.length, 4 * positions.length, ...(colors ? [4 * colors.length] : [])];
  const targets = [34963, 34962, 34962]; // index, then vertex data
  const count = positions.length / 3;
  const vectors = { componentType: 5126, count, type: 'VEC3' };
  return {
    asset: { version: '2.0', generator: 'Whittle' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [
      { primitives: [{ attributes: { POSITION: 1, ...(colors ? { COLOR_0: 2 } : {}) }, indices: 0 }] },
    ],
    accessors: [
      { bufferView: 0, componentType: 5125, count: triangles.length, type: 'SCALAR' },
      { bufferView: 1, ...vectors, ...floatBounds(positions) },
      ...(colors ? [{ bufferView: 2, ...vectors }] : []),
    ],
    bufferViews: lengths.map((byteLength, i) => {
      const byteOffset = lengths.slice(0, i).reduce((sum, length) => sum + length, 0);
      return { buffer: 0, byteOffset, byteLength, target: targets[i] };
    }),
    buffers: [uri === undefined ? { byteLength: bin.length } : { byteLength: bin.length, uri }],
  };
}

/** The smallest and largest of the positions as the file has them, rounded. */
function floatBounds(positions: Float64Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const value = Math.fround(positions[i]);
    min[i % 3] = Math.min(min[i % 3], value);
    max[i % 3] = Math.max(max[i % 3], value);
  }
  return { min, max };
}
