import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Command } from './commands.ts';

/** What one command line left behind. */
export interface Result {
  readonly file: Uint8Array;
  /** What the report says of each step; times and warnings may be others. */
  readonly steps: readonly Step[];
}

export interface Step {
  readonly method: string;
  readonly iterations: number;
  readonly outcome: string;
  readonly energy: readonly number[];
}

/**
 * Runs a command line of a set-up tree in the folder of the inputs and reads what it wrote.
 *
 * @param into path of the result without its ending
 * @throws Error, with what the program said, where it ends with anything but 0
 */
export function runIn(tree: string, [line, ending]: Command, inputs: string, into: string): Result {
  const [out, report] = [`${into}.${ending}`, `${into}.json`];
  // The program that `npx whittle` starts in that tree.
  const program = join(tree, 'node_modules/.bin/whittle');
  const words = [...line.split(' '), '--out', out, '--report', report, '--quiet'];
  const { status, stderr, error } = spawnSync(program, words, { cwd: inputs, encoding: 'utf8' });
  if (status !== 0)
    throw new Error(`whittle ${line} ended with ${status} in ${tree}:\n${error?.message ?? stderr}`);
  const { steps } = JSON.parse(readFileSync(report, 'utf8')) as { steps: Step[] };
  return { file: readFileSync(out), steps };
}
