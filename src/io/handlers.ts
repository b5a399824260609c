import { patch3mf } from './3mf/patch.ts';
import { lookOf3mf, scan3mf } from './3mf/scan.ts';
import { write3mf } from './3mf/write.ts';
import type { FilesBeside, Reference } from './beside.ts';
import type { Format } from './formats.ts';
import { GltfDocument } from './gltf/document.ts';
import { lookOfGltf } from './gltf/look.ts';
import { packGlb, packGltf, piecesOf } from './gltf/pack.ts';
import { patchGltf } from './gltf/patch.ts';
import { scanGltf } from './gltf/scan.ts';
import { writeGlb, writeGltf } from './gltf/write.ts';
import { type Look, plainLook } from './look/look.ts';
import type { Room } from './look/losses.ts';
import { lookOfObj, referencesOfObj } from './obj/look.ts';
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

/** A file that was parsed, with what is needed to give it back with other positions. */
export interface Parsed {
  readonly file: ParsedFile;
  patch(positions: Float64Array): Bytes;
  /** Names, materials and textures; made when it is asked for. */
  look(): Look;
}

/** What a format can do. */
interface Handler {
  read(bytes: Uint8Array, name: string, beside: FilesBeside): Parsed;
  /** The files beside one that it refers to, itself or by those that are there already. Default: none. */
  readonly references?: (bytes: Uint8Array, name: string, beside: FilesBeside) => readonly Reference[];
  /** Makes a new file. */
  write(shape: Shape): Bytes;
  /** What a new file has room for. */
  readonly room: Room;
  /** Other formats that a file, given back with other positions, becomes without losing anything. */
  readonly repack?: Partial<Record<Format, (bytes: Bytes, name: string, beside: FilesBeside) => Bytes>>;
}

/** Ties a reader to its patcher, which needs to know more of the file than others do. */
function reader<File extends ParsedFile>(
  scan: (bytes: Uint8Array, name: string, beside: FilesBeside) => File,
  patch: (source: Uint8Array, file: File, positions: Float64Array, name: string) => Bytes,
  look: (bytes: Uint8Array, file: File, beside: FilesBeside) => Look = () => plainLook,
): Handler['read'] {
  return (bytes, name, beside) => {
    const file = scan(bytes, name, beside);
    return {
      file,
      patch: (positions) => patch(bytes, file, positions, name),
      look: () => look(bytes, file, beside),
    };
  };
}

const everything: Room = { colors: true, uvs: true, names: true, materials: 'whole' };

/** The formats, one line each. */
export const handlers: Readonly<Record<Format, Handler>> = {
  obj: {
    read: reader(scanObj, patchObj, lookOfObj),
    references: referencesOfObj,
    write: writeObj,
    room: { ...everything, materials: 'names' },
  },
  'stl-binary': { read: reader(scanStlBinary, patchStlBinary), write: writeStlBinary, room: {} },
  'stl-ascii': { read: reader(scanStlText, patchStlText), write: writeStlText, room: {} },
  'ply-ascii': { read: reader(scanPly, patchPly), write: writePlyText, room: { colors: true, uvs: true } },
  'ply-binary': { read: reader(scanPly, patchPly), write: writePlyBinary, room: { colors: true, uvs: true } },
  '3mf': { read: reader(scan3mf, patch3mf, lookOf3mf), write: write3mf, room: {} },
  off: { read: reader(scanOff, patchOff), write: writeOff, room: { colors: true } },
  glb: {
    references: (bytes, name) => new GltfDocument(bytes, name, true).references(),
    read: reader((bytes, name, beside) => scanGltf(bytes, name, true, beside), patchGltf, lookOfGltf),
    write: writeGlb,
    room: everything,
    repack: {
      gltf: (bytes, name, beside) => packGltf(piecesOf(new GltfDocument(bytes, name, true, beside))),
    },
  },
  gltf: {
    read: reader((bytes, name, beside) => scanGltf(bytes, name, false, beside), patchGltf, lookOfGltf),
    references: (bytes, name) => new GltfDocument(bytes, name, false).references(),
    write: writeGltf,
    room: everything,
    repack: {
      glb: (bytes, name, beside) => packGlb(piecesOf(new GltfDocument(bytes, name, false, beside))),
    },
  },
};
