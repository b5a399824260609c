import { type Format, readMesh, writeMesh } from '../io/index.ts';
import type { Services } from './services.ts';

/** The file formats of `io`. */
export const fileServices: Pick<Services, 'readMesh' | 'writeMesh'> = {
  readMesh,
  // A format comes from outside and may be anything; writeMesh refuses what is none.
  writeMesh: (source, name, format, positions) => writeMesh(source, name, format as Format, positions),
};
