import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));

/**
 * Loads a TypeScript module of this tree through Vite, so that it uses the very modules of the library, and runs it. What it
 * throws ends the process with 1 and its message.
 */
export async function runThroughVite(module, use) {
  const server = await createServer({
    root,
    configFile: false,
    appType: 'custom',
    logLevel: 'error',
    server: { middlewareMode: true, hmr: false, ws: false },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    await use(await server.ssrLoadModule(module));
  } catch (error) {
    console.error(error.message);
    process.exitCode = 1;
  } finally {
    await server.close();
  }
}
