import type { Weld } from '../../mesh/mesh.ts';
import { chains } from './chains.ts';
import { choice } from './choice.ts';
import { flag } from './flag.ts';
import { handles } from './handles.ts';
import { number } from './number.ts';
import type { Encoded, Parameter, ValueHelp, ValueKind } from './parameter.ts';
import { planes } from './planes.ts';
import { rotation } from './rotation.ts';
import { rotations } from './rotations.ts';
import { scalars } from './scalars.ts';
import { sphereField } from './sphere-field.ts';
import { style } from './style.ts';
import { textureSlopes } from './texture-slopes.ts';
import { vector } from './vector.ts';

/** Every kind of value, by the name that descriptors and the core give it: the one table of them. */
const kinds = {
  number,
  integer: number,
  flag,
  choice,
  vector,
  rotation,
  scalars,
  rotations,
  sphereField,
  style,
  textureSlopes,
  handles,
  planes,
  chains,
};

type Kind = (typeof kinds)[keyof typeof kinds];

/** A parameter of any kind. */
export type ParameterDescriptor = Kind extends infer Each
  ? Each extends ValueKind<infer Descriptor, never>
    ? Descriptor
    : never
  : never;

/** A value of any kind. */
export type ParameterValue = Kind extends infer Each
  ? // biome-ignore lint/suspicious/noExplicitAny: only the value is asked for
    Each extends ValueKind<any, infer Value>
    ? Value
    : never
  : never;

/** Values by parameter name; what is absent has its default. */
export type ParameterValues = Readonly<Record<string, ParameterValue>>;

/** What is wrong with a value, as data; recipe, engine and command line make their own error of it. */
export interface ParameterProblem {
  readonly code: 'bad-parameter' | 'bad-handles' | 'bad-planes';
  readonly parameter: string;
  /** One sentence that names the parameter, the value and what is allowed. */
  readonly message: string;
}

/** Holds a value of unknown origin against its descriptor. Whether vertices exist is for the engine, which knows the mesh. */
export function checkValue(descriptor: ParameterDescriptor, value: unknown): ParameterProblem | undefined {
  const { problem, code = 'bad-parameter' } = kindOf(descriptor);
  const what = problem(descriptor, value);
  if (what === undefined) return undefined;
  return { code, parameter: descriptor.name, message: `“${descriptor.name}” ${what}` };
}

/**
 * Lays a checked value out for the core.
 *
 * @throws WhittleError as {@link ValueKind.encode}
 */
export function encodeValue(descriptor: ParameterDescriptor, value: ParameterValue, weld: Weld): Encoded {
  return kindOf(descriptor).encode(descriptor, value, weld);
}

export function valueHelp(descriptor: ParameterDescriptor): ValueHelp {
  return kindOf(descriptor).help(descriptor);
}

/** Whether a parameter's value may be the name of something: a file, an asset, one of ours. */
export function takesNames(descriptor: ParameterDescriptor): boolean {
  return kindOf(descriptor).takesNames === true;
}

/** Whether what was typed after a parameter's flag is the name of a JSON file that holds the value. */
export function namesFile(descriptor: ParameterDescriptor, text: string): boolean {
  const { isFile, fromText } = kindOf(descriptor);
  return isFile ? isFile(descriptor, text) : fromText === undefined;
}

/** The value that was typed after a parameter's flag, not checked yet. */
export function typedValue(descriptor: ParameterDescriptor, text: string): unknown {
  return kindOf(descriptor).fromText?.(text) ?? text;
}

/** The kind of a descriptor, which is the one that it names. */
function kindOf({ kind }: ParameterDescriptor): ValueKind<Parameter, ParameterValue> {
  return kinds[kind] as unknown as ValueKind<Parameter, ParameterValue>;
}
