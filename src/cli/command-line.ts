import { readFile } from 'node:fs/promises';
import type { Engine } from '../engine/client.ts';
import { createNodeEngine } from '../engine/in-node.ts';
import { methods } from '../methods/registry.ts';
import { type Command, parseCommand } from './command.ts';
import { generalHelp, methodHelp, methodsHelp } from './help.ts';
import { runJob } from './job.ts';
import { exitCodes, explain } from './problems.ts';
import { ProgressLine, type ProgressStream } from './progress.ts';
import type { RunReport } from './report.ts';
import { type RunCommand, workOf } from './work.ts';

/** Where a command line reads and writes, and how it hears of Ctrl-C. */
export interface Terminal {
  /** Default: empty. */
  readonly stdin?: AsyncIterable<Uint8Array>;
  readonly stdout: { write(text: string): unknown };
  readonly stderr: ProgressStream;
  readonly signal: AbortSignal;
}

/**
 * The whole command line.
 *
 * @param words arguments after the program's name
 * @param openEngine another engine than the built one, for tests
 * @returns the exit code; whatever went wrong has been said on stderr in one line
 */
export async function runCommandLine(
  words: readonly string[],
  terminal: Terminal,
  openEngine: () => Engine = createNodeEngine,
): Promise<number> {
  try {
    await carryOut(parseCommand(words), terminal, openEngine);
    return exitCodes.done;
  } catch (thrown) {
    const { code, line } = explain(thrown);
    terminal.stderr.write(`${line}\n`);
    return code;
  }
}

async function carryOut(command: Command, terminal: Terminal, openEngine: () => Engine): Promise<void> {
  switch (command.kind) {
    case 'help':
      terminal.stdout.write(command.method ? methodHelp(command.method) : generalHelp());
      return;
    case 'version':
      terminal.stdout.write(`${await version()}\n`);
      return;
    case 'methods':
      terminal.stdout.write(command.json ? `${JSON.stringify(methods, null, 2)}\n` : methodsHelp());
      return;
    default:
      await run(command, terminal, openEngine);
  }
}

async function run(
  command: RunCommand,
  { stdin, stderr, signal }: Terminal,
  openEngine: () => Engine,
): Promise<void> {
  const { files } = command;
  const work = await workOf(command, stdin);
  const progress = new ProgressLine(stderr, files.quiet);
  const engine = openEngine();
  let report: RunReport;
  try {
    report = await runJob(engine, { ...work, files, progress, signal });
  } finally {
    progress.clear();
    engine.dispose();
  }
  if (files.quiet) return;
  for (const warning of report.steps.flatMap(({ warnings }) => warnings)) {
    stderr.write(`${warning.startsWith(files.input) ? '' : `${files.input}: `}${warning}\n`);
  }
  if (stderr.isTTY) stderr.write(summary(files.out, report));
}

function summary(out: string, { steps }: RunReport): string {
  const lines = steps.map(
    ({ method, iterations, outcome, milliseconds: { read, prepare, solve, write } }) => {
      const seconds = ((read + prepare + solve + write) / 1000).toFixed(1);
      return `${out}: ${method}, ${iterations} iterations, ${outcome}, ${seconds} s\n`;
    },
  );
  return lines.join('');
}

/** The package file lies at the same place from src/cli and from dist/cli. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  return (JSON.parse(text) as { version: string }).version;
}
