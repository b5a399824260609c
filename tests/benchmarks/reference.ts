import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/**
 * Checks a git reference out into a folder of its own and hands it to `use`. The checkout goes again, whatever happens.
 *
 * @throws Error where git does not know the reference
 */
export async function withCheckout(
  reference: string,
  use: (folder: string, commit: string) => Promise<void>,
): Promise<void> {
  const commit = commitOf(reference);
  const parent = mkdtempSync(join(tmpdir(), 'whittle-base-'));
  const folder = join(parent, 'base');
  const remove = (): void => {
    spawnSync('git', ['worktree', 'remove', '--force', folder]);
    rmSync(parent, { recursive: true, force: true });
    spawnSync('git', ['worktree', 'prune']);
  };
  const interrupted = (): never => {
    remove();
    process.exit(130);
  };
  process.once('SIGINT', interrupted);
  process.once('SIGTERM', interrupted);
  try {
    run('git', ['worktree', 'add', '--detach', folder, commit]);
    await use(folder, commit);
  } finally {
    process.off('SIGINT', interrupted);
    process.off('SIGTERM', interrupted);
    remove();
  }
}

function commitOf(reference: string): string {
  try {
    return run('git', ['rev-parse', '--short', '--verify', '--end-of-options', `${reference}^{commit}`]);
  } catch {
    throw new Error(`Git knows no commit by the name “${reference}”.`);
  }
}

/**
 * Builds only the wasm module of a checkout, into its `wasm/dist`.
 *
 * @throws Error, with the last lines of the compiler, where it does not build
 */
export function buildCore(folder: string, reference: string): void {
  console.error(`Building the core of ${reference} as wasm …`);
  const [source, into] = [join(folder, 'wasm'), join(folder, 'wasm/build/wasm')];
  try {
    run('emcmake', ['cmake', '-S', source, '-B', into, '-G', 'Ninja']);
    run('cmake', ['--build', into, '--target', 'whittle-core']);
  } catch (cause) {
    throw new Error(`The core of ${reference} does not build here. ${(cause as Error).message}`);
  }
}

/**
 * Does the whole set-up of a checkout, after which its command line runs: packages, wasm module, `whittle`.
 *
 * @throws Error, with the last lines of what failed
 */
export function setUpCommandLine(folder: string, reference: string): void {
  console.error(`Setting ${reference} up …`);
  try {
    run(process.execPath, [join(folder, 'wasm/tools/setup.mjs'), 'start']);
  } catch (cause) {
    throw new Error(`${reference} cannot be set up here. ${(cause as Error).message}`);
  }
}

function run(command: string, args: readonly string[]): string {
  // Debian's em++ finds its JavaScript tools only through NODE_PATH.
  const modules = existsSync('/usr/share/nodejs') ? { NODE_PATH: '/usr/share/nodejs' } : {};
  const options = { encoding: 'utf8', env: { ...process.env, ...modules }, maxBuffer: 1 << 28 } as const;
  const { status, stdout, stderr, error } = spawnSync(command, args, options);
  if (status === 0) return stdout.trim();
  const lines = (error?.message ?? `${stdout}\n${stderr}`).trim().split('\n').slice(-20).join('\n');
  throw new Error(`${command} ${args[0]} failed:\n${lines}`);
}
