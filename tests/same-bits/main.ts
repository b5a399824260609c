import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { markdownTable } from '../benchmarks/numbers.ts';
import { setUpCommandLine, withCheckout } from '../benchmarks/reference.ts';
import { type Command, commands } from './commands.ts';
import { compare } from './compare.ts';
import { writeInputs } from './inputs.ts';
import { runIn } from './trees.ts';

const usage = `usage: npm run same-bits -- --against REF
  runs ${commands.length} command lines on this tree and on that commit or branch and compares what they write byte by byte`;

/**
 * Runs every command line on this tree and on that of a git reference, prints a table, and keeps the files of both where some
 * differ.
 *
 * @throws Error with the usage, where a command line fails, and where results differ
 */
export async function sameBits(args: readonly string[]): Promise<void> {
  const [flag, reference, ...more] = args;
  if (flag !== '--against' || !reference || more.length > 0) throw new Error(usage);
  await withCheckout(reference, async (folder, commit) => {
    setUpCommandLine(folder, reference);
    const desk = mkdtempSync(join(tmpdir(), 'whittle-same-bits-'));
    const differing = compareTrees({ base: folder, head: process.cwd() }, desk, `${reference} (${commit})`);
    if (differing > 0)
      throw new Error(`${differing} of ${commands.length} results differ; all files are in ${desk}.`);
    rmSync(desk, { recursive: true });
    console.log(`All ${commands.length} results are the same, byte for byte.`);
  });
}

interface Trees {
  readonly base: string;
  readonly head: string;
}

/** How many command lines have other results. */
function compareTrees({ base, head }: Trees, desk: string, title: string): number {
  const inputs = join(desk, 'inputs');
  writeInputs(inputs);
  for (const side of ['base', 'head']) mkdirSync(join(desk, side));
  let differing = 0;
  const rows = commands.map((command: Command, index) => {
    const [line, ending] = command;
    console.error(`whittle ${line} …`);
    const was = runIn(base, command, inputs, join(desk, 'base', String(index + 1)));
    const is = runIn(head, command, inputs, join(desk, 'head', String(index + 1)));
    const { file = 'same', energy = 'same' } = compare(was, is);
    if (file !== 'same' || energy !== 'same') differing++;
    const iterations = is.steps.map((step) => step.iterations).join(' + ');
    return [String(index + 1), line, ending, iterations, String(is.file.length), file, energy];
  });
  const headers = ['', 'whittle', 'out', 'iterations', 'bytes', 'file', 'energy'];
  console.log(`Working tree against ${title}:\n\n${markdownTable(headers, rows)}\n`);
  return differing;
}
