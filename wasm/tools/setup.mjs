// Set-up of a checkout, run by every README command: node packages, compilers, wasm, command line. Needs nothing
// but Node; does only what is missing or stale, and says so only then.
import { spawnSync } from 'node:child_process';
import { existsSync, symlinkSync } from 'node:fs';
import { chdir } from 'node:process';
import { fileURLToPath } from 'node:url';
import { buildBenchmark, buildTests, buildWasm } from './build.mjs';
import { fail, runQuietly } from './run.mjs';
import { fingerprint, isFresh, markFresh } from './stamps.mjs';
import { requireTools } from './system-tools.mjs';

const needsOf = {
  start: ['wasm'],
  build: ['wasm'],
  bench: ['wasm', 'native'],
  test: ['wasm', 'native', 'browser'],
};

const purpose = process.argv[2] ?? 'start';
if (!(purpose in needsOf))
  fail(`setup: unknown purpose “${purpose}”; it is one of ${Object.keys(needsOf).join(', ')}.`);

chdir(fileURLToPath(new URL('../..', import.meta.url)));
requireNode();
installPackages();
requireTools(needsOf[purpose]);
buildWasm();
if (purpose === 'test') buildTests();
if (purpose === 'bench') buildBenchmark();
buildCommandLine();

function requireNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major > 20 || (major === 20 && minor >= 19)) return;
  fail(
    `Whittle needs Node 20.19 or newer; this is ${process.versions.node}. Install a newer one from your package manager.`,
  );
}

function installPackages() {
  const state = fingerprint(['package-lock.json']);
  if (existsSync('node_modules') && isFresh('packages', state)) return;
  runQuietly('Installing node packages', 'npm', ['ci', '--no-audit', '--no-fund']);
  markFresh('packages', state);
}

/** `npx whittle` runs the compiled command line; the link is what installing the package would have made. */
function buildCommandLine() {
  const link = 'node_modules/.bin/whittle';
  const state = fingerprint(['src', 'tsconfig.json', 'package-lock.json']);
  if (
    !existsSync('src/cli/tsconfig.json') ||
    (existsSync('dist/cli/main.js') && existsSync(link) && isFresh('cli', state))
  )
    return;
  runQuietly('Compiling the command line', 'node_modules/.bin/tsc', ['-p', 'src/cli']);
  spawnSync('chmod', ['+x', 'dist/cli/main.js']);
  if (!existsSync(link)) symlinkSync('../../dist/cli/main.js', link);
  markFresh('cli', state);
}
