import type {
  ChoiceParameter,
  FlagParameter,
  MethodDescriptor,
  NumberParameter,
  ParameterDescriptor,
  ParameterValues,
} from '../../src/methods/descriptor.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { Shaping, WhittleDocument } from './document.ts';
import { startingLambda, startingRegularizer, startingStrength } from './starting-lambda.ts';

/** Parameters with a control of their own; handles, styles and weights per vertex have tools. */
export type EditableParameter = NumberParameter | ChoiceParameter | FlagParameter;

function isEditable(parameter: ParameterDescriptor): parameter is EditableParameter {
  if (parameter.kind === 'choice') return !parameter.isForLibrary;
  return ['number', 'integer', 'flag'].includes(parameter.kind);
}

/** Parameters that the panel can set. */
export function editableParameters(method: MethodDescriptor): readonly EditableParameter[] {
  return method.parameters.filter(isEditable);
}

/** Methods that a person can do something with here: at least one plain control, not only fine-tuning. */
export function offeredMethods(all: readonly MethodDescriptor[] = methods): readonly MethodDescriptor[] {
  return all.filter((method) => editableParameters(method).some(({ advanced }) => !advanced));
}

/** Methods that borrow from a style: the gallery's. */
export function takesStyle(method: MethodDescriptor | undefined): boolean {
  return method?.parameters.some(({ kind }) => kind === 'style') ?? false;
}

/** What a method opens with on a mesh: its defaults, but for what depends on the mesh and the style. */
export function startingParameters(
  method: MethodDescriptor,
  { report, style }: Pick<WhittleDocument, 'report' | 'style'>,
): ParameterValues {
  const values: Record<string, number | string | boolean> = {};
  for (const parameter of editableParameters(method)) values[parameter.name] = parameter.default;
  if (typeof values.lambda !== 'number') return values;
  if (!takesStyle(method) || !style) return { ...values, lambda: startingLambda(report.vertices) };
  const regularizer = startingRegularizer(report, style.map);
  return { ...values, lambda: startingStrength(style.map), regularizer };
}

/** What the engine gets. */
export function solverParameters({ method, parameters, style }: Shaping): ParameterValues {
  return style && takesStyle(findMethod(method)) ? { ...parameters, style: style.map } : parameters;
}
