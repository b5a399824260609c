import type { MethodDescriptor } from './descriptor.ts';
import { didYouMean } from './suggest.ts';
import { checkValue, type ParameterProblem } from './values/index.ts';

/**
 * Holds values against a method's descriptor: unknown names, wrong kinds, numbers out of range. What is absent is fine.
 *
 * @param values typed as `unknown` because recipes and pages can hand over anything
 * @returns the first problem, or undefined
 */
export function checkParameters(
  method: MethodDescriptor,
  values: Readonly<Record<string, unknown>>,
): ParameterProblem | undefined {
  for (const [name, value] of Object.entries(values)) {
    const descriptor = method.parameters.find((parameter) => parameter.name === name);
    const problem = descriptor ? checkValue(descriptor, value) : unknownParameter(method, name);
    if (problem) return problem;
  }
  return undefined;
}

function unknownParameter({ id, parameters }: MethodDescriptor, name: string): ParameterProblem {
  const hint = didYouMean(
    name,
    parameters.map((parameter) => parameter.name),
  );
  return {
    code: 'bad-parameter',
    parameter: name,
    message: `The method “${id}” has no parameter “${name}”.${hint}`,
  };
}
