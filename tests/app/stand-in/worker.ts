import { loadCore } from '../../../src/engine/core.ts';
import type { ServerPort } from '../../../src/engine/port.ts';
import { serve } from '../../../src/engine/server.ts';
import { readMesh } from './read-mesh.ts';

serve(globalThis as unknown as ServerPort, { loadCore, readMesh, writeMesh: (source) => source.slice() });
