import { type FilesBeside, nothingBeside } from './beside.ts';
import { GltfDocument } from './gltf/document.ts';
import { type Compression, compressionsOf, type Decoders, expandGltf } from './gltf/expand.ts';
import { packGlb, packGltf } from './gltf/pack.ts';

export type { Compression, Decoders, DracoAttributes, DracoMesh } from './gltf/expand.ts';

/** A file without compression. */
export interface PlainFile {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** What to say of it when it is opened. */
  readonly warnings: readonly string[];
}

/**
 * Undoes the compression of a file, if it is a glTF or GLB that is compressed with Draco or meshopt; any other file as it is.
 * Reading and writing work on what comes out.
 *
 * @param load loads a decoder; called only where a file needs it
 * @throws WhittleError unsupported-file, truncated-file or malformed-file where compressed data cannot be decoded
 */
export async function uncompressed(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  load: (compression: Compression) => Promise<Decoders>,
  beside: FilesBeside = nothingBeside,
): Promise<PlainFile> {
  const document = documentOf(bytes, name, beside);
  const compressions = document ? compressionsOf(document) : [];
  if (!document || compressions.length === 0) return { bytes, warnings: [] };
  const decoders: Decoders = Object.assign({}, ...(await Promise.all(compressions.map(load))));
  const pieces = expandGltf(document, decoders);
  const what = compressions.join(' and ');
  return {
    bytes: document.isBinary ? packGlb(pieces) : packGltf(pieces),
    warnings: [`It is compressed with ${what}; the result is not, and hence larger.`],
  };
}

/** Undefined for what is no glTF, or a broken one: what is wrong with it is said when it is read. */
function documentOf(bytes: Uint8Array, name: string, beside: FilesBeside): GltfDocument | undefined {
  const isBinary = bytes[0] === 0x67 && bytes[1] === 0x6c && bytes[2] === 0x54 && bytes[3] === 0x46;
  if (!isBinary && !beginsAsJson(bytes)) return undefined;
  try {
    return new GltfDocument(bytes, name, isBinary, beside);
  } catch {
    return undefined;
  }
}

function beginsAsJson(bytes: Uint8Array): boolean {
  const first = bytes.subarray(0, 64).find((byte) => byte > 32 && byte < 128);
  return first === 123;
}
