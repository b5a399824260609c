import { didYouMean } from '../methods/suggest.ts';
import { UsageError } from './problems.ts';

/** What stood on the command line: `--name value`, `--name=value`, `--switch`, and the rest in order. */
export interface Flags {
  readonly values: ReadonlyMap<string, string>;
  readonly switches: ReadonlySet<string>;
  readonly rest: readonly string[];
}

/** Names without dashes. */
interface Known {
  readonly values: readonly string[];
  /** Written alone. */
  readonly switches: readonly string[];
  /** Written alone for true, or with `=true` or `=false`. */
  readonly flags?: readonly string[];
}

/** Flags that every command understands. */
export const commonFlags = { values: [] as readonly string[], switches: ['help'] as readonly string[] };

/**
 * Takes arguments apart. What follows a value flag is its value whatever it looks like, so that `--lambda -1` is understood
 * (and then refused for its range); `--` ends the flags.
 *
 * @param known names without dashes
 * @throws UsageError
 */
export function parseFlags(words: readonly string[], known: Known): Flags {
  const values = new Map<string, string>();
  const switches = new Set<string>();
  const rest: string[] = [];
  const queue = [...words];
  for (let word = queue.shift(); word !== undefined; word = queue.shift()) {
    if (word === '--') {
      rest.push(...queue.splice(0));
    } else if (!word.startsWith('-') || word === '-') {
      rest.push(word);
    } else {
      const [name, given] = splitFlag(word);
      if (known.switches.includes(name) && given === undefined) switches.add(name);
      else if (known.flags?.includes(name)) setOnce(values, name, given ?? 'true');
      else if (known.values.includes(name)) setOnce(values, name, given ?? queue.shift());
      else throw unknownFlag(word, name, known);
    }
  }
  return { values, switches, rest };
}

function splitFlag(word: string): [string, string | undefined] {
  if (word === '-h') return ['help', undefined];
  const equals = word.indexOf('=');
  const name = (equals < 0 ? word : word.slice(0, equals)).replace(/^--?/, '');
  return [name, equals < 0 ? undefined : word.slice(equals + 1)];
}

function setOnce(values: Map<string, string>, name: string, value: string | undefined): void {
  if (value === undefined) throw new UsageError(`--${name} needs a value after it.`);
  if (values.has(name)) throw new UsageError(`--${name} is given twice; keep one.`);
  values.set(name, value);
}

function unknownFlag(word: string, name: string, known: Known): UsageError {
  if (known.switches.includes(name)) return new UsageError(`--${name} takes no value, so write it alone.`);
  const names = [...known.values, ...(known.flags ?? []), ...known.switches].map((flag) => `--${flag}`);
  return new UsageError(`there is no flag ${word} here.${didYouMean(`--${name}`, names)}`);
}
