import { ByteWriter } from '../byte-writer.ts';
import { byteFromLinear } from '../color.ts';
import type { Shape } from '../parsed-file.ts';

/** A new OFF file (COFF if the shape has colours): positions and polygons. */
export function writeOff(shape: Shape): Uint8Array<ArrayBuffer> {
  const { positions, colors, faces } = shape;
  const faceCount = faces.start.length - 1;
  const writer = new ByteWriter(12 * positions.length);
  writer.ascii(`${colors ? 'COFF' : 'OFF'}\n${positions.length / 3} ${faceCount} 0\n`);
  for (let i = 0; i < positions.length; i += 3) {
    writer.ascii(`${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
    if (colors) for (let k = i; k < i + 3; k++) writer.ascii(` ${byteFromLinear(colors[k])}`);
    writer.ascii(colors ? ' 255\n' : '\n');
  }
  for (let f = 0; f < faceCount; f++) {
    writer.ascii(String(faces.start[f + 1] - faces.start[f]));
    for (let c = faces.start[f]; c < faces.start[f + 1]; c++) writer.ascii(` ${faces.corners[c]}`);
    writer.ascii('\n');
  }
  return writer.take();
}
