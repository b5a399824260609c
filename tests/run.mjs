// `npm test` after set-up: formatting, types, the C++ tests natively and as wasm, then Vitest (Node and Chromium).
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { chdir, execPath } from 'node:process';
import { fileURLToPath } from 'node:url';

chdir(fileURLToPath(new URL('..', import.meta.url)));
const bin = (name) => `node_modules/.bin/${name}`;
const typed = ['.', 'src/viewer', 'src/cli', 'web', 'tests'].filter((folder) =>
  existsSync(`${folder}/tsconfig.json`),
);

const checks = [
  ['Formatting and lint', bin('biome'), ['check', '--error-on-warnings', '.']],
  ...typed.map((folder) => [`Types of ${folder}`, bin('tsc'), ['-p', folder, '--noEmit']]),
  ['C++ tests, native with sanitizers', 'wasm/build/native-tests/tests/whittle-core-tests', []],
  [
    'C++ tests, wasm in Node',
    execPath,
    ['wasm/build/wasm-tests/tests/whittle-core-tests.cjs', '--no-colors'],
  ],
  ['Vitest', bin('vitest'), ['run', ...process.argv.slice(2)]],
];

for (const [name, command, args] of checks) {
  console.log(`\n── ${name}`);
  const started = performance.now();
  const { status } = spawnSync(command, args, { stdio: 'inherit' });
  if (status !== 0) {
    console.error(`\n${name} failed.`);
    process.exit(1);
  }
  console.log(`${((performance.now() - started) / 1000).toFixed(1)} s`);
}
console.log('\nAll tests passed.');
