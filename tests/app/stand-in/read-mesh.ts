import type { ReadResult } from '../../../src/engine/protocol.ts';
import { WhittleError } from '../../../src/mesh/failure.ts';

/** Just enough of a file layer to look at the page without one: plain GLB, OBJ and ASCII PLY of known shape. */
export function readMesh(bytes: Uint8Array<ArrayBuffer>, name: string): ReadResult {
  if (name.endsWith('.glb')) return readGlb(bytes);
  const lines = new TextDecoder().decode(bytes).split('\n');
  if (lines[0] === 'ply') return readPly(lines);
  if (name.endsWith('.obj')) return readObj(lines);
  throw new WhittleError(
    'unknown-format',
    `${name} is no mesh file; open an OBJ, STL, PLY, OFF or glTF file.`,
  );
}

function readGlb(bytes: Uint8Array<ArrayBuffer>): ReadResult {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  const binary = bytes.slice(28 + length).buffer;
  const [primitive] = json.meshes[0].primitives;
  const place = (index: number) => {
    const accessor = json.accessors[index];
    return { count: accessor.count, offset: json.bufferViews[accessor.bufferView].byteOffset };
  };
  const at = place(primitive.attributes.POSITION);
  const positions = Float64Array.from(new Float32Array(binary, at.offset, 3 * at.count));
  const index = place(primitive.indices);
  const triangles = new Uint32Array(binary, index.offset, index.count).slice();
  return { mesh: { positions, triangles, hasUvs: false }, format: 'glb', warnings: [] };
}

function readObj(lines: readonly string[]): ReadResult {
  const positions: number[] = [];
  const triangles: number[] = [];
  lines.forEach((line, number) => {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') positions.push(...rest.map(Number));
    if (word !== 'f') return;
    const corners = rest.map((corner) => Number.parseInt(corner, 10) - 1);
    if (corners.some(Number.isNaN)) {
      throw new WhittleError(
        'malformed-file',
        `Line ${number + 1} is no face; mend it and open it again.`,
        number + 1,
      );
    }
    for (let i = 2; i < corners.length; i++) triangles.push(corners[0]!, corners[i - 1]!, corners[i]!);
  });
  const mesh = {
    positions: Float64Array.from(positions),
    triangles: Uint32Array.from(triangles),
    hasUvs: false,
  };
  return { mesh, format: 'obj', warnings: [] };
}

function readPly(lines: readonly string[]): ReadResult {
  const count = (name: string) =>
    Number(lines.find((line) => line.startsWith(`element ${name}`))!.split(' ')[2]);
  const first = lines.indexOf('end_header') + 1;
  const rows = (from: number, many: number) =>
    lines.slice(from, from + many).map((line) => line.split(' ').map(Number));
  const vertices = rows(first, count('vertex'));
  const faces = rows(first + count('vertex'), count('face'));
  const mesh = {
    positions: Float64Array.from(vertices.flatMap((row) => row.slice(0, 3))),
    triangles: Uint32Array.from(faces.flatMap((row) => row.slice(1, 4))),
    colors: Float32Array.from(vertices.flatMap((row) => row.slice(3, 6).map((band) => (band / 255) ** 2.2))),
    hasUvs: false,
  };
  return { mesh, format: 'ply-ascii', warnings: [] };
}
