import type { FilesBeside, Reference, WrittenMesh } from '../io/index.ts';
import type { Core } from './core-api.ts';
import type { ReadResult } from './protocol.ts';

/** What the server needs from outside: the core and the file formats. Tests bring their own. */
export interface Services {
  /** Called at the first mesh: files need no core. If it fails, the next mesh tries again. */
  readonly loadCore: () => Promise<Core>;
  /** @throws WhittleError with a file's code */
  readonly readMesh: (
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    beside?: FilesBeside,
  ) => ReadResult | Promise<ReadResult>;
  /** @throws WhittleError with a file's code */
  readonly referencesOf: (
    bytes: Uint8Array<ArrayBuffer>,
    name: string,
    beside?: FilesBeside,
  ) => readonly Reference[];
  /** @throws WhittleError with a file's code */
  readonly writeMesh: (
    source: Uint8Array<ArrayBuffer>,
    name: string,
    format: string,
    positions: Float64Array<ArrayBuffer>,
    beside?: FilesBeside,
  ) => WrittenMesh | Promise<WrittenMesh>;
}
