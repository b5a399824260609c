import { type Format, readMesh, referencesOf, writeMesh } from '../io/index.ts';
import type { Services } from './services.ts';

/** The file formats of `io`. */
export const fileServices: Pick<Services, 'readMesh' | 'referencesOf' | 'writeMesh'> = {
  readMesh,
  referencesOf,
  // A format comes from outside and may be anything; writeMesh refuses what is none.
  writeMesh: (source, name, format, positions, beside) =>
    writeMesh(source, name, format as Format, positions, beside),
};
