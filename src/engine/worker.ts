import { loadCore } from './core.ts';
import { fileServices } from './file-services.ts';
import type { ServerPort } from './port.ts';
import { serve } from './server.ts';

/** The web worker's script. */
serve(globalThis as unknown as ServerPort, { ...fileServices, loadCore: () => loadCore() });
