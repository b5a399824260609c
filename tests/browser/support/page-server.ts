import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { build, preview } from 'vite';

const root = (path: string) => fileURLToPath(new URL(`../../../${path}`, import.meta.url));

export interface PageServer {
  readonly url: string;
  close(): Promise<void>;
}

/** Builds the page as it is shipped and serves it on a free port of this machine. */
export async function servePage(): Promise<PageServer> {
  const configFile = root('vite.config.ts');
  const outDir = root('tests/out/page');
  await build({ configFile, logLevel: 'error', build: { outDir } });
  const server = await preview({
    configFile,
    logLevel: 'error',
    build: { outDir },
    preview: { port: 0, host: '127.0.0.1' },
  });
  const { port } = server.httpServer.address() as AddressInfo;
  return { url: `http://127.0.0.1:${port}/`, close: () => server.close() };
}
