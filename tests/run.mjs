// Checks and tests, each with the set-up that it needs.
//   node tests/run.mjs PIECE …              several pieces, one after the other; ends at the first that fails
//   node tests/run.mjs PIECE [ARGUMENT …]   one piece, its programs given the arguments
import { spawnSync } from 'node:child_process';
import { chdir, execPath } from 'node:process';
import { fileURLToPath } from 'node:url';

chdir(fileURLToPath(new URL('..', import.meta.url)));
const bin = (name) => `node_modules/.bin/${name}`;
const vitest = (title, project) => [title, bin('vitest'), 'run', '--project', project];

/** Programs of each piece: a title, the command and its arguments. */
const pieces = {
  format: [
    ['Formatting and lint', bin('biome'), 'check', '--error-on-warnings', '.'],
    ['Formatting of the C++', execPath, 'tests/clang-format.mjs'],
  ],
  types: ['.', 'src/viewer', 'src/element', 'src', 'web', 'tests'].map((folder) => [
    `Types of ${folder}`,
    ...[bin('tsc'), '-p', folder, '--noEmit'],
  ]),
  core: [
    ['C++ tests, native with sanitizers', 'wasm/build/native-tests/tests/whittle-core-tests'],
    [
      'C++ tests, wasm in Node',
      ...[execPath, 'wasm/build/wasm-tests/tests/whittle-core-tests.cjs', '--no-colors'],
    ],
  ],
  'core-release': [['C++ tests, native release', 'wasm/build/release-tests/tests/whittle-core-tests']],
  library: [vitest('Library, command line and page logic, in Node', 'node')],
  chromium: [vitest('The page in Chromium', 'chromium')],
  figures: [vitest('The papers’ figures, made on the page', 'figures')],
  firefox: [vitest('The page in Firefox', 'firefox')],
};

const words = process.argv.slice(2);
const isPiece = (word) => Object.hasOwn(pieces, word);
const firstArgument = words.findIndex((word) => !isPiece(word));
const wanted = firstArgument < 0 ? words : words.slice(0, firstArgument);
const passedOn = words.slice(wanted.length);
if (wanted.length === 0) fail(`Name what to run: ${Object.keys(pieces).join(', ')}.`);
if (wanted.length > 1 && passedOn.length > 0)
  fail(
    `${passedOn.join(' ')} can be passed on to one piece only, as in: npm run test:library -- tests/editor`,
  );

if (run([execPath, 'wasm/tools/setup.mjs', ...wanted]) !== 0) process.exit(1);
for (const [title, ...command] of wanted.flatMap((name) => pieces[name])) {
  console.log(`\n── ${title}`);
  const started = performance.now();
  if (run([...command, ...passedOn]) !== 0) fail(`\n${title} failed.`);
  console.log(`${((performance.now() - started) / 1000).toFixed(1)} s`);
}
console.log('\nAll passed.');

function run([command, ...args]) {
  const { status, error } = spawnSync(command, args, { stdio: 'inherit' });
  if (error) console.error(error.message);
  return status;
}

function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}
