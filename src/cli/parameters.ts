import { WhittleError } from '../mesh/failure.ts';
import type { MethodDescriptor, ParameterDescriptor, ParameterValues } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { checkParameters } from '../methods/values/check.ts';
import { parseJson } from '../recipe/index.ts';
import { readText } from './files.ts';
import { UsageError } from './problems.ts';

/**
 * Parameter values from what was typed. Numbers and choices are checked before any file is opened.
 *
 * @param typed by parameter name
 * @throws UsageError for a typed value, `WhittleError` or `FileError` for a JSON file, which the message names
 */
export async function readParameters(
  method: MethodDescriptor,
  typed: ReadonlyMap<string, string>,
): Promise<ParameterValues> {
  const values: Record<string, unknown> = {};
  for (const descriptor of method.parameters) {
    const text = typed.get(descriptor.name);
    if (text === undefined || isFile(descriptor, text)) continue;
    values[descriptor.name] = plainValue(descriptor, text);
    const problem = checkParameters(method, { [descriptor.name]: values[descriptor.name] });
    if (problem) throw new UsageError(`--${kebabCase(descriptor.name)}: ${problem.message}`);
  }
  for (const descriptor of method.parameters) {
    const file = typed.get(descriptor.name);
    if (file === undefined || !isFile(descriptor, file)) continue;
    values[descriptor.name] = parseJson(await readText(file), file);
    const problem = checkParameters(method, { [descriptor.name]: values[descriptor.name] });
    if (problem) throw new WhittleError(problem.code, `${file}: ${problem.message}`);
  }
  // Each of them checked above.
  return values as ParameterValues;
}

/** Whether what was typed is the name of a JSON file. */
function isFile(descriptor: ParameterDescriptor, text: string): boolean {
  if (descriptor.kind === 'choice') return Boolean(descriptor.maxRows) && /\.json$/i.test(text);
  return ['handles', 'scalars', 'rotations'].includes(descriptor.kind);
}

/** What does not look right stays text, for the check to quote. */
function plainValue({ kind }: ParameterDescriptor, text: string): unknown {
  if (kind === 'flag') return text === 'true' || text === 'false' ? text === 'true' : text;
  if (kind === 'vector' || kind === 'rotation') return text.split(',').map(numberOf);
  return kind === 'number' || kind === 'integer' ? numberOf(text) : text;
}

/** What is no number stays text, for the check to quote. */
function numberOf(text: string): number | string {
  const value = Number(text);
  return text.trim() === '' || Number.isNaN(value) ? text : value;
}
