import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import { runCommandLine } from '../../src/cli/command-line.ts';
import type { Engine } from '../../src/engine/client.ts';

/** What a command line said and how it ended. */
export interface Said {
  readonly code: number;
  readonly stdout: string;
  readonly stderr: string;
}

/** A folder of its own for the files of one test. */
export class Desk {
  readonly folder: string;

  private constructor(folder: string) {
    this.folder = folder;
  }

  static async open(): Promise<Desk> {
    return new Desk(await mkdtemp(join(tmpdir(), 'whittle-test-')));
  }

  path(name: string): string {
    return join(this.folder, name);
  }

  write(name: string, content: string | object): Promise<void> {
    const isPlain = typeof content === 'string' || content instanceof Uint8Array;
    return writeFile(this.path(name), isPlain ? content : JSON.stringify(content));
  }

  read(name: string): Promise<string> {
    return readFile(this.path(name), 'utf8');
  }

  async list(): Promise<string[]> {
    return (await readdir(this.folder)).sort();
  }

  clear(): Promise<void> {
    return rm(this.folder, { recursive: true });
  }

  /** Runs the command line in this process; words that begin with `@` are files of this folder. */
  async run(line: string, options: RunOptions = {}): Promise<Said> {
    const words = line.split(' ').map((word) => (word.startsWith('@') ? this.path(word.slice(1)) : word));
    let stdout = '';
    let stderr = '';
    const collect = (text: string) => {
      stderr += text;
    };
    const terminal = {
      stdin: Readable.from([Buffer.from(options.stdin ?? '')]),
      stdout: { write: (text: string) => (stdout += text) },
      stderr: { isTTY: options.isTTY ?? false, columns: 200, write: collect },
      signal: options.signal ?? new AbortController().signal,
    };
    const code = await runCommandLine(words, terminal, options.engine);
    return { code, stdout, stderr: stderr.replaceAll(`${this.folder}/`, '') };
  }
}

export interface RunOptions {
  readonly stdin?: string;
  readonly isTTY?: boolean;
  readonly signal?: AbortSignal;
  readonly engine?: () => Engine;
}
