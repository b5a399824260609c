import { ByteWriter } from '../byte-writer.ts';
import { srgbFromLinear } from '../color.ts';
import type { Shape } from '../parsed-file.ts';

/** A new OBJ file: positions (with colours behind, in sRGB) and polygons. */
export function writeObj(shape: Shape): Uint8Array<ArrayBuffer> {
  const { positions, colors, faces } = shape;
  const writer = new ByteWriter(12 * positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    writer.ascii(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
    if (colors) writer.ascii(` ${short(colors[i])} ${short(colors[i + 1])} ${short(colors[i + 2])}`);
    writer.ascii('\n');
  }
  for (let f = 0; f + 1 < faces.start.length; f++) {
    writer.ascii('f');
    for (let c = faces.start[f]; c < faces.start[f + 1]; c++) writer.ascii(` ${faces.corners[c] + 1}`);
    writer.ascii('\n');
  }
  return writer.take();
}

function short(linear: number): string {
  return String(Math.round(srgbFromLinear(linear) * 1e4) / 1e4);
}
