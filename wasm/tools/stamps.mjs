import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const folder = 'node_modules/.whittle';

/** A hash of the contents of files and folders: modification times mean nothing after a checkout. */
export function fingerprint(paths, extra = '') {
  const hash = createHash('sha256').update(extra);
  for (const path of paths) addTo(hash, path);
  return hash.digest('hex');
}

function addTo(hash, path) {
  if (!existsSync(path)) return;
  if (statSync(path).isDirectory()) {
    for (const name of readdirSync(path).sort()) addTo(hash, join(path, name));
  } else {
    hash.update(`${path}\0`).update(readFileSync(path));
  }
}

export function isFresh(name, state) {
  const file = join(folder, name);
  return existsSync(file) && readFileSync(file, 'utf8') === state;
}

export function markFresh(name, state) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, name), state);
}
