import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = (path: string) => fileURLToPath(new URL(`../../../${path}`, import.meta.url));

const types: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
};

/** Builds the three files of the element as it is shipped. @param folder from the root of the tree */
export async function buildElement(folder: string): Promise<void> {
  for (const mode of ['element', 'worker']) {
    const options = { outDir: root(folder), emptyOutDir: mode === 'element' };
    await build({ configFile: root('vite.config.ts'), mode, logLevel: 'error', build: options });
  }
}

/** A path as it was written; one that is not well encoded stays as it is. */
function pathOf(url: string): string {
  const { pathname } = new URL(url, 'http://localhost');
  try {
    return normalize(decodeURIComponent(pathname));
  } catch {
    return pathname;
  }
}

export interface StaticServer {
  readonly url: string;
  /** Paths that were asked for. */
  readonly asked: string[];
  close(): Promise<void>;
}

/**
 * Serves plain files as any web server does: no cross-origin isolation, other origins may read.
 *
 * @param folders by the first part of the path
 * @param pages texts by their path
 * @param csp of the pages, if any
 */
export async function serveStatic(
  folders: Readonly<Record<string, string>>,
  pages: Readonly<Record<string, string>> = {},
  csp?: string,
): Promise<StaticServer> {
  const asked: string[] = [];
  const server = createServer(async (request, response) => {
    const path = pathOf(request.url!);
    asked.push(path);
    response.setHeader('access-control-allow-origin', '*');
    if (csp) response.setHeader('content-security-policy', csp);
    const [, folder = '', ...rest] = path.split('/');
    try {
      const body = pages[path] ?? (await readFile(join(folders[folder]!, ...rest)));
      response.setHeader('content-type', types[path in pages ? '.html' : extname(path)] ?? 'model/mesh');
      response.end(body);
    } catch {
      response.statusCode = 404;
      response.end('nothing here');
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}`,
    asked,
    close: () => new Promise((resolve) => server.close(() => resolve())),
  };
}
