import type { ChosenStyle, Shaping, StylePlace, WhittleDocument } from '../../src/editor/project.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import type { FlagParameter } from '../../src/methods/values/flag.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import type { ParameterDescriptor, ParameterValue, ParameterValues } from '../../src/methods/values/index.ts';
import type { NumberParameter } from '../../src/methods/values/number.ts';
import type { StyleParameter } from '../../src/methods/values/style.ts';
import { laid, type Picture, startingRepeat } from './image-gallery.ts';

/** Parameters with a control of their own; handles, styles and weights per vertex have tools. */
export type EditableParameter = NumberParameter | ChoiceParameter | FlagParameter;

function isEditable(parameter: ParameterDescriptor): parameter is EditableParameter {
  return ['number', 'integer', 'flag', 'choice'].includes(parameter.kind);
}

/** Parameters that the panel can set. How a style is read follows from the gallery; a picture of one's own can be read in several ways. */
export function editableParameters(
  method: MethodDescriptor,
  picture?: Picture | null,
): readonly EditableParameter[] {
  const isReading = ({ kind, isForLibrary }: ParameterDescriptor) => kind === 'choice' && isForLibrary;
  const hasReadings = takesPicture(method) && picture?.isOwn;
  return method.parameters.filter(isEditable).filter((one) => hasReadings || !isReading(one));
}

/** Methods that a person can do something with here: at least one plain control, not only fine-tuning. */
export function offeredMethods(all: readonly MethodDescriptor[] = methods): readonly MethodDescriptor[] {
  return all.filter((method) => editableParameters(method).some(({ advanced }) => !advanced));
}

/** The parameter by which a method borrows from a style: the gallery's. */
export function styleParameter(
  method: MethodDescriptor | undefined,
): (StyleParameter & { readonly name: StylePlace }) | undefined {
  const found = method?.parameters.find(({ kind }) => kind === 'style');
  // The document has a place for each.
  return found as (StyleParameter & { readonly name: StylePlace }) | undefined;
}

/** Whether a method can borrow from such a style. */
export function canTake(method: MethodDescriptor | undefined, map: GaussMap): boolean {
  const parameter = styleParameter(method);
  return parameter !== undefined && (parameter.mapping === undefined || map.kind === 'closest');
}

/** The style of the method that is on; null if it takes none or none was chosen. */
export function styleOf(shaping: Shaping): ChosenStyle | null {
  const parameter = styleParameter(findMethod(shaping.method));
  return parameter ? shaping[parameter.name] : null;
}

/** Methods that make shape of a picture. */
export function takesPicture(method: MethodDescriptor | undefined): boolean {
  return method?.parameters.some(({ kind }) => kind === 'textureSlopes') ?? false;
}

/** Why a method cannot be used on a mesh, as a sentence; undefined if it can. */
export function obstacle(
  method: MethodDescriptor,
  { mesh }: Pick<WhittleDocument, 'mesh'>,
): string | undefined {
  if (!takesPicture(method) || mesh.uvs) return undefined;
  return `${method.title} lays a picture on the mesh by its texture coordinates, and this mesh has none; unwrap it and export it with UVs.`;
}

/** What a method opens with on a mesh: its defaults, but for what depends on the mesh and the style. */
export function startingParameters(
  method: MethodDescriptor,
  { report, style, mesh, picture }: Pick<WhittleDocument, 'report' | 'style' | 'mesh' | 'picture'>,
): ParameterValues {
  const values: Record<string, ParameterValue> = {};
  for (const parameter of editableParameters(method, picture)) values[parameter.name] = parameter.default;
  if (takesPicture(method)) return picture ? { ...values, repeat: startingRepeat(picture, mesh) } : values;
  return { ...values, ...method.startingValues?.({ report, style: style?.map ?? null }) };
}

/** What the engine gets. */
export function solverParameters(document: WhittleDocument): ParameterValues {
  const { parameters, picture, mesh } = document;
  const method = findMethod(document.method);
  if (picture && takesPicture(method))
    return { ...parameters, image: laid(picture, mesh, parameters).relief };
  const parameter = styleParameter(method);
  const style = styleOf(document);
  return parameter && style ? { ...parameters, [parameter.name]: style.map } : parameters;
}
