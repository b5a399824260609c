// Holds the C++ against .clang-format, which is written for one version of the program: others break lines elsewhere.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const wanted = /clang-format (\d+)/.exec(readFileSync('.clang-format', 'utf8'))[1];
const program = [`clang-format-${wanted}`, 'clang-format'].find((name) =>
  new RegExp(`version ${wanted}\\.`).exec(output(name, ['--version']) ?? ''),
);
if (!program) {
  console.error(
    `clang-format ${wanted} is not here; install it to have the C++ checked (Debian 12: clang-format).`,
  );
  // Where continuous integration runs it must be there; elsewhere another version is no reason to fail.
  process.exit(process.env.CI ? 1 : 0);
}
const files = output('git', ['ls-files', 'wasm/*.cpp', 'wasm/*.h', 'tests/core/*.cpp', 'tests/core/*.h'])
  .trim()
  .split('\n');
const { status } = spawnSync(program, ['--dry-run', '--Werror', ...files], { stdio: 'inherit' });
if (status !== 0) console.error(`To mend it: ${program} -i FILE …`);
process.exit(status ?? 1);

function output(command, args) {
  const done = spawnSync(command, args, { encoding: 'utf8' });
  return done.status === 0 ? done.stdout : undefined;
}
