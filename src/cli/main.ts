#!/usr/bin/env node
import { runCommandLine } from './command-line.ts';

const interrupt = new AbortController();
// Only the first Ctrl-C is ours; without a listener the second ends the process.
process.once('SIGINT', () => interrupt.abort());

const { stdin, stdout, stderr } = process;
const terminal = { stdin, stdout, stderr, signal: interrupt.signal };
process.exitCode = await runCommandLine(process.argv.slice(2), terminal);
