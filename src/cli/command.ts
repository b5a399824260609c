import { resolve } from 'node:path';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { findMethod, methods } from '../methods/registry.ts';
import { didYouMean } from '../methods/suggest.ts';
import { type Flags, parseFlags } from './flags.ts';
import { UsageError } from './problems.ts';

/** Where the files of a run are. */
export interface RunFiles {
  readonly input: string;
  readonly out: string;
  readonly report: string | undefined;
  readonly quiet: boolean;
}

/** What the command line asks for. */
export type Command =
  | { readonly kind: 'help'; readonly method: MethodDescriptor | undefined }
  | { readonly kind: 'version' }
  | { readonly kind: 'methods'; readonly json: boolean }
  | {
      readonly kind: 'recipe';
      /** A recipe, a project whose recipe is meant, or `-` for a recipe from stdin. */
      readonly recipe: string;
      /** Its `input` is the recipe's file itself where that is a project whose own mesh is meant. */
      readonly files: RunFiles;
    }
  | {
      readonly kind: 'method';
      readonly method: MethodDescriptor;
      /** By parameter name, as typed; object-valued ones name a JSON file. */
      readonly values: ReadonlyMap<string, string>;
      readonly files: RunFiles;
    };

const runValues = ['out', 'report'];
const runSwitches = ['quiet', 'help'];

/** @throws UsageError */
export function parseCommand(words: readonly string[]): Command {
  const [name, ...rest] = words;
  if (name === undefined)
    throw new UsageError(
      'say what to do, for example “whittle cubic in.obj --out out.obj”; --help shows more.',
    );
  if (name === '--help' || name === '-h') return { kind: 'help', method: undefined };
  if (name === '--version') return { kind: 'version' };
  if (name === 'methods') return parseMethods(rest);
  if (name === 'run') return parseRun(rest);
  const method = findMethod(name);
  if (method) return parseMethod(method, rest);
  const commands = [...methods.map(({ id }) => id), 'run', 'methods'];
  throw new UsageError(`there is no command ${name}.${didYouMean(name, commands)}`);
}

function parseMethods(words: readonly string[]): Command {
  const { switches, rest } = parseFlags(words, { values: [], switches: ['json', 'help'] });
  if (rest.length > 0) throw new UsageError(`“whittle methods” takes no ${rest[0]}.`);
  return switches.has('help')
    ? { kind: 'help', method: undefined }
    : { kind: 'methods', json: switches.has('json') };
}

function parseRun(words: readonly string[]): Command {
  const flags = parseFlags(words, { values: runValues, switches: runSwitches });
  if (flags.switches.has('help')) return { kind: 'help', method: undefined };
  const [recipe, ...rest] = flags.rest;
  if (recipe === undefined)
    throw new UsageError('name the recipe and the mesh: whittle run recipe.json in.obj --out out.obj');
  // A project brings its mesh along.
  const meshes = rest.length === 0 && /\.zip$/i.test(recipe) ? [recipe] : rest;
  return { kind: 'recipe', recipe, files: filesOf({ ...flags, rest: meshes }) };
}

function parseMethod(method: MethodDescriptor, words: readonly string[]): Command {
  const names = new Map(method.parameters.map(({ name }) => [kebabCase(name), name]));
  const isFlag = (flag: string) =>
    method.parameters.some(({ name, kind }) => kind === 'flag' && kebabCase(name) === flag);
  const flags = parseFlags(words, {
    values: [...[...names.keys()].filter((flag) => !isFlag(flag)), ...runValues],
    flags: [...names.keys()].filter(isFlag),
    switches: runSwitches,
  });
  if (flags.switches.has('help')) return { kind: 'help', method };
  const values = new Map<string, string>();
  for (const [flag, value] of flags.values) {
    const parameter = names.get(flag);
    if (parameter !== undefined) values.set(parameter, value);
  }
  return { kind: 'method', method, values, files: filesOf(flags) };
}

function filesOf({ values, switches, rest }: Flags): RunFiles {
  const [input, stray] = rest;
  const out = values.get('out');
  if (input === undefined) throw new UsageError('name the mesh file to work on, for example in.obj.');
  if (stray !== undefined)
    throw new UsageError(`one mesh at a time; ${stray} is too many. The result goes to --out.`);
  if (out === undefined) throw new UsageError('say where the result goes: --out out.obj');
  const report = values.get('report');
  if (report !== undefined && [input, out].some((path) => resolve(path) === resolve(report)))
    throw new UsageError(`--report ${report} would overwrite the mesh; give it a name of its own.`);
  return { input, out, report, quiet: switches.has('quiet') };
}
