// Checks and tests, each with the set-up that it needs.
//   node tests/run.mjs PIECE …              several pieces, their programs side by side; starts no more once one has failed
//   node tests/run.mjs PIECE [ARGUMENT …]   one piece, its programs one after the other and given the arguments
import { spawn, spawnSync } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { chdir, execPath } from 'node:process';
import { text } from 'node:stream/consumers';
import { fileURLToPath } from 'node:url';

chdir(fileURLToPath(new URL('..', import.meta.url)));
const bin = (name) => `node_modules/.bin/${name}`;
const vitest = (title, project) => [title, bin('vitest'), 'run', '--project', project];

/** Programs of each piece: a title, the command and its arguments. Those that take longest stand first, so that none runs alone in the end. */
const pieces = {
  format: [
    ['Formatting and lint', bin('biome'), 'check', '--error-on-warnings', '.'],
    ['Formatting of the C++', execPath, 'tests/clang-format.mjs'],
  ],
  types: ['.', 'src/viewer', 'src/element', 'src', 'web', 'tests'].map((folder) => [
    `Types of ${folder}`,
    ...[bin('tsc'), '-p', folder, '--noEmit'],
  ]),
  firefox: [vitest('The page in Firefox', 'firefox')],
  chromium: [vitest('The page in Chromium', 'chromium')],
  figures: [vitest('The papers’ figures, made on the page', 'figures')],
  library: [vitest('Library, command line and page logic, in Node', 'node')],
  core: [
    ['C++ tests, native with sanitizers', 'wasm/build/native-tests/tests/whittle-core-tests'],
    ['C++ tests, wasm in Node', ...[execPath, 'wasm/build/wasm/tests/whittle-core-tests.cjs', '--no-colors']],
  ],
  'core-release': [['C++ tests, native release', 'wasm/build/release-tests/tests/whittle-core-tests']],
};
/** What is over in seconds and needs nothing built; it is run before anything is. */
const quick = ['format', 'types'];

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

if (wanted.length === 1) inTurn(wanted[0]);
else {
  const ordered = Object.keys(pieces).filter((name) => wanted.includes(name));
  await sideBySide(ordered.filter((name) => quick.includes(name)));
  await sideBySide(ordered.filter((name) => !quick.includes(name)));
}
console.log('\nAll passed.');

/** Each program of a piece, its output as it comes. */
function inTurn(piece) {
  setUp([piece]);
  for (const [title, command, ...args] of pieces[piece]) {
    console.log(`\n── ${title}`);
    const started = performance.now();
    const { status, error } = spawnSync(command, [...args, ...passedOn], { stdio: 'inherit' });
    if (error) console.error(error.message);
    if (status !== 0) fail(`\n${title} failed.`);
    console.log(secondsSince(started));
  }
}

/** All programs of some pieces, as many at a time as there are processors; the output of each once it is over. */
async function sideBySide(names) {
  if (names.length === 0) return;
  setUp(names);
  const waiting = names.flatMap((name) => pieces[name]);
  const failed = [];
  const lane = async () => {
    for (let next = waiting.shift(); next && failed.length === 0; next = waiting.shift())
      if (!(await passes(next))) failed.push(next[0]);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, lane));
  if (failed.length > 0) fail(`\nFailed: ${failed.join('; ')}.`);
}

async function passes([title, command, ...args]) {
  const started = performance.now();
  console.log(`${title} …`);
  const program = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => {
    program.on('error', ({ message }) => resolve(message));
    program.on('close', resolve);
  });
  const output = await Promise.all([text(program.stdout), text(program.stderr)]);
  const outcome = await ended;
  console.log(`\n── ${title}\n${output.join('')}${secondsSince(started)}`);
  if (typeof outcome === 'string') console.error(outcome);
  return outcome === 0;
}

function setUp(names) {
  const { status } = spawnSync(execPath, ['wasm/tools/setup.mjs', ...names], { stdio: 'inherit' });
  if (status !== 0) process.exit(1);
}

function secondsSince(started) {
  return `${((performance.now() - started) / 1000).toFixed(1)} s`;
}

function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}
