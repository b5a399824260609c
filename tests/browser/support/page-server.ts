import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { build, preview } from 'vite';

const root = (path: string) => fileURLToPath(new URL(`../../../${path}`, import.meta.url));
const configFile = root('vite.config.ts');

export interface PageServer {
  readonly url: string;
  close(): Promise<void>;
}

/** Builds the page as it is shipped. @param folder from the root of the tree */
export async function buildPage(folder: string): Promise<void> {
  await build({ configFile, logLevel: 'error', build: { outDir: root(folder) } });
}

/** Serves a built page on a free port of this machine. */
export async function servePage(folder: string): Promise<PageServer> {
  const server = await preview({
    configFile,
    logLevel: 'error',
    build: { outDir: root(folder) },
    preview: { port: 0, host: '127.0.0.1' },
  });
  const { port } = server.httpServer.address() as AddressInfo;
  return { url: `http://127.0.0.1:${port}/`, close: () => server.close() };
}
