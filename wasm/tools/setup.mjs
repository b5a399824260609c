// Set-up of a checkout, run by every README command: node packages, compilers, wasm, command line. Needs nothing
// but Node; does only what is missing or stale, and says so only then.
//   node wasm/tools/setup.mjs [PURPOSE …]
import { spawnSync } from 'node:child_process';
import { existsSync, symlinkSync } from 'node:fs';
import { chdir } from 'node:process';
import { fileURLToPath } from 'node:url';
import { buildBenchmark, buildReleaseTests, buildTests, buildWasm } from './build.mjs';
import { fail, runQuietly } from './run.mjs';
import { fingerprint, isFresh, markFresh } from './stamps.mjs';
import { requireTools } from './system-tools.mjs';

/** What each purpose needs beside node packages: tools of the system, by their `for`, and what is built with them. */
const purposes = {
  start: { tools: ['wasm'], build: [buildWasm, buildCommandLine] },
  build: { tools: ['wasm'], build: [buildWasm, buildCommandLine] },
  bench: { tools: ['wasm', 'native'], build: [buildWasm, buildBenchmark, buildCommandLine] },
  // The pieces of tests/run.mjs.
  format: { tools: ['format'], build: [] },
  types: { tools: [], build: [] },
  core: { tools: ['wasm', 'native'], build: [buildTests] },
  'core-release': { tools: ['native', 'wasm'], build: [buildReleaseTests] },
  library: { tools: ['wasm'], build: [buildWasm, buildCommandLine] },
  chromium: { tools: ['wasm', 'chromium'], build: [buildWasm] },
  figures: { tools: ['wasm', 'chromium'], build: [buildWasm] },
  firefox: { tools: ['wasm', 'firefox'], build: [buildWasm] },
};

const wanted = process.argv.length > 2 ? process.argv.slice(2) : ['start'];
for (const name of wanted)
  if (!(name in purposes))
    fail(`setup: unknown purpose “${name}”; it is one of ${Object.keys(purposes).join(', ')}.`);

chdir(fileURLToPath(new URL('../..', import.meta.url)));
requireNode();
installPackages();
requireTools(wanted.flatMap((name) => purposes[name].tools));
for (const build of new Set(wanted.flatMap((name) => purposes[name].build))) build();

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
  if (existsSync('dist/cli/main.js') && existsSync(link) && isFresh('cli', state)) return;
  runQuietly('Compiling the library and the command line', 'node_modules/.bin/tsc', ['-p', 'src']);
  spawnSync('chmod', ['+x', 'dist/cli/main.js']);
  if (!existsSync(link)) symlinkSync('../../dist/cli/main.js', link);
  markFresh('cli', state);
}
