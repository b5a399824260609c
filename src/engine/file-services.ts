import {
  type Compression,
  type FilesBeside,
  type Format,
  readMesh,
  referencesOf,
  uncompressed,
  writeMesh,
} from '../io/index.ts';
import { loadDecoder } from './decoders.ts';
import type { Services } from './services.ts';

type FileServices = Pick<Services, 'readMesh' | 'referencesOf' | 'writeMesh'>;

/** The file formats of `io`. @param readDraco the bytes of Draco's decoder, asked for by files that need it */
export function fileServices(readDraco: () => Promise<Uint8Array>): FileServices {
  const load = (compression: Compression) => loadDecoder(compression, readDraco);
  const plain = (bytes: Uint8Array<ArrayBuffer>, name: string, beside?: FilesBeside) =>
    uncompressed(bytes, name, load, beside);
  return {
    referencesOf,
    readMesh: async (source, name, beside) => {
      const { bytes, warnings } = await plain(source, name, beside);
      const read = readMesh(bytes, name, beside);
      return { ...read, warnings: [...warnings, ...read.warnings] };
    },
    // A format comes from outside and may be anything; writeMesh refuses what is none.
    writeMesh: async (source, name, format, positions, beside) => {
      const { bytes } = await plain(source, name, beside);
      return writeMesh(bytes, name, format as Format, positions, beside);
    },
  };
}
