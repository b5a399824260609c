import { ByteWriter } from '../byte-writer.ts';
import { encodeUtf8 } from '../bytes.ts';
import { srgbFromLinear } from '../color.ts';
import { splitByUv } from '../look/corners.ts';
import type { Part } from '../look/look.ts';
import type { Shape } from '../parsed-file.ts';

/** A new OBJ file: positions (with colours behind, in sRGB), texture coordinates, polygons, names of parts and materials. */
export function writeObj(shape: Shape): Uint8Array<ArrayBuffer> {
  const { positions, colors, faces, uvs, look } = shape;
  const writer = new ByteWriter(12 * positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    writer.ascii(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
    if (colors) writer.ascii(` ${short(colors[i])} ${short(colors[i + 1])} ${short(colors[i + 2])}`);
    writer.ascii('\n');
  }
  const uvOfCorner = uvs && writeUvs(writer, shape, uvs);
  let part = 0;
  for (let f = 0; f + 1 < faces.start.length; f++) {
    for (; look.parts[part]?.firstFace === f; part++)
      writePart(writer, shape, look.parts[part], look.parts[part - 1]);
    writer.ascii('f');
    for (let c = faces.start[f]; c < faces.start[f + 1]; c++) {
      writer.ascii(` ${faces.corners[c] + 1}`);
      if (uvOfCorner && uvOfCorner[c] > 0) writer.ascii(`/${uvOfCorner[c]}`);
    }
    writer.ascii('\n');
  }
  return writer.take();
}

/** Each pair of a position once. @returns #C: the number of each corner's pair, from 1; 0 where it has none */
function writeUvs(writer: ByteWriter, shape: Shape, uvs: Float32Array): Uint32Array {
  const split = splitByUv(shape, uvs);
  const numbers = new Uint32Array(split.uvs.length / 2);
  let count = 0;
  for (let v = 0; v < numbers.length; v++) {
    const [u, up] = [split.uvs[2 * v], split.uvs[2 * v + 1]];
    if (Number.isNaN(u) || Number.isNaN(up)) continue;
    writer.ascii(`vt ${u} ${up}\n`);
    numbers[v] = ++count;
  }
  return split.vertexOfCorner.map((vertex) => numbers[vertex]);
}

function writePart(writer: ByteWriter, { look }: Shape, part: Part, before: Part | undefined): void {
  const lines: string[] = [];
  if (part.name !== (before?.name ?? '')) lines.push(`o ${part.name}`);
  const material = part.material === undefined ? undefined : look.materials[part.material];
  if (material && part.material !== before?.material) lines.push(`usemtl ${material.name}`);
  for (const line of lines) {
    const bytes = encodeUtf8(`${line.replaceAll(/[\r\n]/g, ' ')}\n`);
    writer.copy(bytes, 0, bytes.length);
  }
}

function short(linear: number): string {
  return String(Math.round(srgbFromLinear(linear) * 1e4) / 1e4);
}
