import { type FilesBeside, nameOfPath, type Reference } from '../io/index.ts';
import type { Engine } from './client.ts';

/** Where files that lie beside a mesh file come from. */
export interface Gathering {
  /** The bytes of a file by its path from the mesh file's folder; undefined if it is not there. */
  readonly read: (path: string) => Promise<Uint8Array<ArrayBuffer> | undefined>;
  /** Which are worth reading. Default: all. */
  readonly wanted?: (reference: Reference) => boolean;
  readonly signal?: AbortSignal;
}

/**
 * Reads the files that a mesh file refers to, and those that these refer to, each by its path or else by its name alone. What
 * cannot be found is left out.
 */
export async function gatherBeside(
  engine: Engine,
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  { read, wanted = () => true, signal }: Gathering,
): Promise<FilesBeside> {
  const found = new Map<string, Uint8Array<ArrayBuffer>>();
  const asked = new Set<string>();
  for (;;) {
    // A file that is none of ours refers to nothing; that it is none is said when it is read.
    const references = await engine.references(bytes, name, { beside: found, signal }).catch(() => []);
    const next = references.filter((reference) => !asked.has(reference.path) && wanted(reference));
    if (next.length === 0) return found;
    for (const { path } of next) {
      asked.add(path);
      const file = (await read(path)) ?? (await read(nameOfPath(path)));
      if (file) found.set(path, file);
    }
  }
}
