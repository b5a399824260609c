import { imageParameter, styleParameter } from '../../src/editor/starting-step.ts';
import { isPlain } from '../../src/inputs/starting-values.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { intents, type MethodDescriptor } from '../../src/methods/descriptor.ts';
import { methods } from '../../src/methods/registry.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import type { FlagParameter } from '../../src/methods/values/flag.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import type { ParameterDescriptor } from '../../src/methods/values/index.ts';
import type { NumberParameter } from '../../src/methods/values/number.ts';

/** Parameters with a control of their own; handles, styles and weights per vertex have tools. */
export type EditableParameter = NumberParameter | ChoiceParameter | FlagParameter;

/** Parameters that the panel can set. How a style is read follows from the gallery; an image of one's own can be read in several ways. */
export function editableParameters(
  method: MethodDescriptor,
  hasOwnImage = false,
): readonly EditableParameter[] {
  const isReading = ({ kind, isForLibrary }: ParameterDescriptor) => kind === 'choice' && isForLibrary;
  const hasReadings = imageParameter(method) !== undefined && hasOwnImage;
  return method.parameters.filter(isPlain).filter((one) => hasReadings || !isReading(one));
}

/** Methods that a person may want, in the order of what they want. */
export function offeredMethods(all: readonly MethodDescriptor[] = methods): readonly MethodDescriptor[] {
  return intents.flatMap(({ id }) => all.filter(({ intent }) => intent === id));
}

/** The methods by what a person wants; a want that no method serves is left out. */
export function methodsByIntent(): readonly {
  readonly title: string;
  readonly methods: readonly MethodDescriptor[];
}[] {
  return intents
    .map(({ id, title }) => ({ title, methods: methods.filter(({ intent }) => intent === id) }))
    .filter((group) => group.methods.length > 0);
}

/** Whether a method can borrow from such a style. */
export function canTake(method: MethodDescriptor | undefined, map: GaussMap): boolean {
  const parameter = styleParameter(method);
  return parameter !== undefined && (parameter.mapping === undefined || map.kind === 'closest');
}

/** Why a method cannot be used on a mesh, as a sentence; undefined if it can. */
export function obstacle(method: MethodDescriptor, mesh: Mesh): string | undefined {
  if (imageParameter(method) === undefined || mesh.uvs) return undefined;
  return `${method.title} lays an image on the mesh by its texture coordinates, and this mesh has none; unwrap it and export it with UVs.`;
}
