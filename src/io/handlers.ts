import type { Format } from './formats.ts';
import { patchGltf } from './gltf/patch.ts';
import { scanGltf } from './gltf/scan.ts';
import { writeGlb, writeGltf } from './gltf/write.ts';
import { patchObj } from './obj/patch.ts';
import { scanObj } from './obj/scan.ts';
import { writeObj } from './obj/write.ts';
import { patchOff } from './off/patch.ts';
import { scanOff } from './off/scan.ts';
import { writeOff } from './off/write.ts';
import type { ParsedFile, Shape } from './parsed-file.ts';
import { patchPly } from './ply/patch.ts';
import { scanPly } from './ply/scan.ts';
import { writePlyBinary, writePlyText } from './ply/write.ts';
import { patchStlBinary, patchStlText } from './stl/patch.ts';
import { scanStlText } from './stl/scan-ascii.ts';
import { scanStlBinary } from './stl/scan-binary.ts';
import { writeStlBinary, writeStlText } from './stl/write.ts';

type Bytes = Uint8Array<ArrayBuffer>;

/** What a format can do. */
interface Handler {
  /** Parses a file, and keeps what is needed to give it back with other positions. */
  read(bytes: Uint8Array, name: string): { file: ParsedFile; patch(positions: Float64Array): Bytes };
  /** Makes a new file. */
  write(shape: Shape): Bytes;
}

/** Ties a reader to its patcher, which needs to know more of the file than others do. */
function handler<File extends ParsedFile>(
  scan: (bytes: Uint8Array, name: string) => File,
  patch: (source: Uint8Array, file: File, positions: Float64Array, name: string) => Bytes,
  write: (shape: Shape) => Bytes,
): Handler {
  return {
    read(bytes, name) {
      const file = scan(bytes, name);
      return { file, patch: (positions) => patch(bytes, file, positions, name) };
    },
    write,
  };
}

/** The formats, one line each. */
export const handlers: Readonly<Record<Format, Handler>> = {
  obj: handler(scanObj, patchObj, writeObj),
  'stl-binary': handler(scanStlBinary, patchStlBinary, writeStlBinary),
  'stl-ascii': handler(scanStlText, patchStlText, writeStlText),
  'ply-ascii': handler(scanPly, patchPly, writePlyText),
  'ply-binary': handler(scanPly, patchPly, writePlyBinary),
  off: handler(scanOff, patchOff, writeOff),
  glb: handler((bytes, name) => scanGltf(bytes, name, true), patchGltf, writeGlb),
  gltf: handler((bytes, name) => scanGltf(bytes, name, false), patchGltf, writeGltf),
};
