import type { MethodDescriptor } from './descriptor.ts';
import type { ChainsParameter } from './values/chains.ts';
import type { ChoiceParameter } from './values/choice.ts';
import type { Handles } from './values/handles.ts';
import type { ParameterDescriptor, ParameterValues } from './values/index.ts';
import type { Planes } from './values/planes.ts';

/** The parameters that a person sets on the mesh itself, by what they are for. A method that has none of a kind cannot be touched so. */

/** Vertices held at places. */
export const handlesParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'handles');

/** Whether its handles are whole sides rather than spots. */
export function gripsSides(method: MethodDescriptor | undefined): boolean {
  return method?.parameters.some((one) => one.kind === 'handles' && one.grip === 'side') ?? false;
}

/** Whether a step that moves nothing but by hand has nothing in hand yet: neither handles nor planes. */
export function isUnheld(method: MethodDescriptor | undefined, values: ParameterValues): boolean {
  if (method?.intent !== 'move') return false;
  const [handles, planes] = [handlesParameter(method), planesParameter(method)].map(
    (name) => name && values[name],
  ) as [Handles | undefined, Planes | undefined];
  return !handles?.vertices.length && !handles?.fixed?.length && !planes?.length;
}

/** Vertices held on planes. */
export const planesParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'planes');

/** A strength for each vertex. */
export const strengthParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'scalars');

/** A share of the strength for each direction. */
export const fieldParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'sphereField');

/** Regions that are turned. */
export const regionsParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'rotations');

/** How all of it is turned. */
export const orientationParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'rotation');

/** A factor for each axis. */
export const axesParameter = (method: MethodDescriptor | undefined): string | undefined =>
  named(method, 'vector');

/** What normals are drawn to, by a name or by rows of one's own. */
export function polyhedronParameter(method: MethodDescriptor | undefined): ChoiceParameter | undefined {
  return method?.parameters.find(
    (one): one is ChoiceParameter => one.kind === 'choice' && one.maxRows !== undefined,
  );
}

/** Lines along edges, by what they say of the shape. */
export function chainsParameters(method: MethodDescriptor | undefined): readonly ChainsParameter[] {
  return method?.parameters.filter((one): one is ChainsParameter => one.kind === 'chains') ?? [];
}

/** One of whose choices several can be looked at side by side. */
export function comparedParameter(method: MethodDescriptor | undefined): ChoiceParameter | undefined {
  return method?.parameters.find((one): one is ChoiceParameter => one.kind === 'choice' && !!one.toCompare);
}

function named(method: MethodDescriptor | undefined, kind: ParameterDescriptor['kind']): string | undefined {
  return method?.parameters.find((parameter) => parameter.kind === kind)?.name;
}
