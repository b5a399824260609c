import { WhittleError } from '../mesh/failure.ts';
import { checkParameters } from '../methods/check.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { namesFile, type ParameterValues, typedValue } from '../methods/values/index.ts';
import { parseJson } from '../methods/values/json.ts';
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
    if (text === undefined || namesFile(descriptor, text)) continue;
    values[descriptor.name] = typedValue(descriptor, text);
    const problem = checkParameters(method, { [descriptor.name]: values[descriptor.name] });
    if (problem) throw new UsageError(`--${kebabCase(descriptor.name)}: ${problem.message}`);
  }
  for (const descriptor of method.parameters) {
    const file = typed.get(descriptor.name);
    if (file === undefined || !namesFile(descriptor, file)) continue;
    values[descriptor.name] = parseJson(await readText(file), file);
    const problem = checkParameters(method, { [descriptor.name]: values[descriptor.name] });
    if (problem) throw new WhittleError(problem.code, `${file}: ${problem.message}`);
  }
  // Each of them checked above.
  return values as ParameterValues;
}
