import { readFile, realpath, rename, rm, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { FileError } from './problems.ts';

/** @throws FileError */
export async function readBytes(path: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return new Uint8Array(await readFile(path));
  } catch (thrown) {
    throw fileError(path, thrown, 'read');
  }
}

/** The bytes of a file by its path from the folder of another; undefined where there is none to be read. */
export async function readBeside(file: string, path: string): Promise<Uint8Array<ArrayBuffer> | undefined> {
  return readBytes(join(dirname(file), path)).catch(() => undefined);
}

/** @throws FileError */
export async function readText(path: string): Promise<string> {
  return new TextDecoder().decode(await readBytes(path));
}

/** All that a stream brings, to its end. */
export async function readStream(stream: AsyncIterable<Uint8Array>): Promise<Uint8Array<ArrayBuffer>> {
  const pieces: Uint8Array[] = [];
  for await (const piece of stream) pieces.push(piece);
  return new Uint8Array(Buffer.concat(pieces));
}

/** Finds out before the work, not after it, that the folder of an output is not there. */
export async function requireFolderOf(path: string): Promise<void> {
  const folder = dirname(path);
  const found = await stat(folder).catch(() => undefined);
  if (!found?.isDirectory()) throw new FileError(`${path}: there is no folder ${folder}; create it first.`);
}

/**
 * Writes a file wholly or not at all: readers see the old bytes or the new ones. What is no regular file (`/dev/stdout`) is
 * written directly.
 *
 * @throws FileError
 */
export async function writeWhole(path: string, content: Uint8Array | string): Promise<void> {
  const target = await realpath(path).catch(() => path);
  const found = await stat(target).catch(() => undefined);
  if (found && !found.isFile()) {
    await writeFile(target, content).catch((thrown) => {
      throw fileError(path, thrown, 'written');
    });
    return;
  }
  const draft = `${target}.${process.pid}.part`;
  try {
    await writeFile(draft, content, { flag: 'wx', mode: found?.mode ?? 0o666 });
    await rename(draft, target);
  } catch (thrown) {
    await rm(draft, { force: true });
    throw fileError(path, thrown, 'written');
  }
}

const reasons: Readonly<Record<string, string>> = {
  ENOENT: 'there is no such file; check the name.',
  EISDIR: 'this is a folder; name a file.',
  EACCES: 'permission denied; check who owns it.',
  ENOSPC: 'the disk is full; make room and try again.',
};

function fileError(path: string, thrown: unknown, verb: 'read' | 'written'): FileError {
  const { code = '', message } = thrown as NodeJS.ErrnoException;
  return new FileError(`${path}: ${reasons[code] ?? `it cannot be ${verb} (${message}).`}`);
}
