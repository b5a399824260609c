import type { MeshReport } from '../../src/mesh/mesh.ts';
import type { MethodDescriptor, ParameterDescriptor, ParameterValues } from '../../src/methods/descriptor.ts';
import { methods } from '../../src/methods/registry.ts';
import { startingLambda } from './starting-lambda.ts';

/** Parameters that the panel can set. */
export function editableParameters(method: MethodDescriptor): readonly ParameterDescriptor[] {
  return method.parameters.filter((parameter) => ['number', 'integer', 'choice'].includes(parameter.kind));
}

/** Methods that a person can do something with here: at least one plain control, not only fine-tuning. */
export function offeredMethods(all: readonly MethodDescriptor[] = methods): readonly MethodDescriptor[] {
  const needsStyle = (method: MethodDescriptor) => method.parameters.some(({ kind }) => kind === 'style');
  return all.filter(
    (method) => !needsStyle(method) && editableParameters(method).some(({ advanced }) => !advanced),
  );
}

/** What a method opens with on a mesh: its defaults, but for what depends on the mesh. */
export function startingParameters(method: MethodDescriptor, report: MeshReport): ParameterValues {
  const values: Record<string, number | string> = {};
  for (const parameter of editableParameters(method))
    if ('default' in parameter && typeof parameter.default !== 'boolean')
      values[parameter.name] = parameter.default;
  if (typeof values.lambda === 'number') values.lambda = startingLambda(report.vertices);
  return values;
}
