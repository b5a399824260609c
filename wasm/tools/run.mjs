import { spawnSync } from 'node:child_process';

/** Ends with one sentence, without a stack trace. */
export function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}

/** Runs a command silently behind one line of announcement; shows its output only if it fails. */
export function runQuietly(announcement, command, args, env = {}) {
  console.error(`${announcement} …`);
  const done = spawnSync(command, args, {
    encoding: 'utf8',
    env: { ...process.env, ...env },
    maxBuffer: 1 << 28,
  });
  if (done.status === 0) return;
  console.error(done.stdout ?? '');
  console.error(done.stderr ?? done.error?.message ?? '');
  fail(`${announcement} failed (${command} ${args.join(' ')}).`);
}

/** Whether a program answers on PATH; with its output, or undefined. */
export function probe(command, args = ['--version']) {
  const done = spawnSync(command, args, { encoding: 'utf8' });
  return done.status === 0 ? done.stdout : undefined;
}
