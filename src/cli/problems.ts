import { WhittleError } from '../mesh/failure.ts';

export const exitCodes = {
  done: 0,
  /** A file is missing, broken or cannot be worked on. */
  badInput: 1,
  wrongUsage: 2,
  /** The computation failed; nothing was written. */
  failed: 3,
  /** Interrupted before there was anything to keep, as shells number it. */
  interrupted: 130,
} as const;

/** The command line itself was wrong. */
export class UsageError extends Error {}

/** A file could not be opened, read or written; the message begins with its name. */
export class FileError extends Error {}

/** Exit code and the one line that goes to stderr. */
export function explain(thrown: unknown): { code: number; line: string } {
  const message = thrown instanceof Error ? thrown.message : String(thrown);
  const line = message.replaceAll(/\s*\n\s*/g, ' ');
  if (thrown instanceof UsageError) return { code: exitCodes.wrongUsage, line: `whittle: ${line}` };
  if (thrown instanceof FileError) return { code: exitCodes.badInput, line };
  if (thrown instanceof WhittleError) return { code: codeOf(thrown), line };
  if (thrown instanceof Error && thrown.name === 'AbortError') {
    return { code: exitCodes.interrupted, line: 'whittle: interrupted, nothing was written.' };
  }
  return { code: exitCodes.failed, line: `whittle: something went wrong (${line}). Please report it.` };
}

function codeOf({ code }: WhittleError): number {
  const isOurs = ['numerical-failure', 'out-of-memory', 'worker-lost', 'internal'].includes(code);
  return isOurs ? exitCodes.failed : exitCodes.badInput;
}
