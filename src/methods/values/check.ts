import type {
  ChoiceParameter,
  MethodDescriptor,
  ParameterDescriptor,
  ScalarsParameter,
  StyleParameter,
  VectorParameter,
} from '../descriptor.ts';
import { didYouMean } from '../suggest.ts';

/** What is wrong with a value, as data; recipe, engine and command line make their own error of it. */
export interface ParameterProblem {
  readonly code: 'bad-parameter' | 'bad-handles';
  readonly parameter: string;
  /** One sentence that names the parameter, the value and what is allowed. */
  readonly message: string;
}

/**
 * The one place that holds values against a method's descriptor: unknown names, wrong kinds, numbers out of range, handles
 * and regions of the wrong shape. What is absent is fine. Whether vertices exist is for the engine, which knows the mesh.
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
    if (!descriptor) {
      const names = method.parameters.map((parameter) => parameter.name);
      return problem(
        'bad-parameter',
        name,
        `The method “${method.id}” has no parameter “${name}”.${didYouMean(name, names)}`,
      );
    }
    const found = checkValue(descriptor, value);
    if (found) return found;
  }
  return undefined;
}

function checkValue(descriptor: ParameterDescriptor, value: unknown): ParameterProblem | undefined {
  const { name } = descriptor;
  switch (descriptor.kind) {
    case 'number':
    case 'integer': {
      const { min, max, kind } = descriptor;
      const isRight = kind === 'integer' ? Number.isInteger(value) : Number.isFinite(value);
      if (isRight && (value as number) >= min && (value as number) <= max) return undefined;
      const wanted = kind === 'integer' ? 'a whole number' : 'a number';
      return problem(
        'bad-parameter',
        name,
        `“${name}” must be ${wanted} from ${min} to ${max}, not ${show(value)}.`,
      );
    }
    case 'flag':
      if (typeof value === 'boolean') return undefined;
      return problem('bad-parameter', name, `“${name}” must be true or false, not ${show(value)}.`);
    case 'choice':
    case 'vector':
    case 'rotation':
    case 'scalars':
    case 'rotations':
    case 'style':
    case 'relief': {
      const what = problemOf(descriptor, value);
      return what === undefined ? undefined : problem('bad-parameter', name, `“${name}” ${what}`);
    }
    case 'handles': {
      const what = handlesProblem(value);
      return what === undefined ? undefined : problem('bad-handles', name, `“${name}” ${what}`);
    }
    default: {
      const unhandled: never = descriptor;
      throw new Error(`no check for ${JSON.stringify(unhandled)}`);
    }
  }
}

type Composite = Exclude<ParameterDescriptor, { kind: 'number' | 'integer' | 'flag' | 'handles' }>;

/** The rest of a sentence that begins with the parameter's name, as of all functions below. */
function problemOf(descriptor: Composite, value: unknown): string | undefined {
  switch (descriptor.kind) {
    case 'choice':
      return choiceProblem(descriptor, value);
    case 'vector':
      return vectorProblem(descriptor, value);
    case 'rotation':
      return isQuaternion(value) ? undefined : `must be ${quaternion}, not ${show(value)}.`;
    case 'scalars':
      return scalarsProblem(descriptor, value);
    case 'rotations':
      return regionsProblem(value);
    case 'style':
      return styleProblem(descriptor, value);
    case 'relief':
      return reliefProblem(value);
  }
}

/** Whether the rows' lengths make sense is for the core. */
function choiceProblem({ choices, maxRows = 0 }: ChoiceParameter, value: unknown): string | undefined {
  if (choices.includes(value as string)) return undefined;
  if (maxRows > 0 && Array.isArray(value)) {
    if (value.length <= maxRows) return directionsProblem(value, 'rows');
    return `must have ${maxRows} rows at most; it has ${value.length}.`;
  }
  const rows = maxRows > 0 ? `, or a list of ${maxRows} rows [x, y, z] at most` : '';
  return `must be one of ${choices.join(', ')}${rows}, not ${show(value)}.`;
}

function vectorProblem({ default: usual, min, max }: VectorParameter, value: unknown): string | undefined {
  const isRight = Array.isArray(value) && value.length === usual.length && value.every(isWithin(min, max));
  if (isRight) return undefined;
  return `must be ${usual.length} numbers from ${min} to ${max}, such as [${usual.join(', ')}], not ${show(value)}.`;
}

function isWithin(min: number, max: number): (entry: unknown) => boolean {
  return (entry) => Number.isFinite(entry) && (entry as number) >= min && (entry as number) <= max;
}

const quaternion = 'a quaternion [x, y, z, w] of finite numbers, not all of them zero';

function isQuaternion(value: unknown): boolean {
  return isPoint(value, 4) && value.some((part) => part !== 0);
}

function regionsProblem(value: unknown): string | undefined {
  const shape = 'must be [{"vertices": [index, …], "orientation": [x, y, z, w]}, …]';
  if (!Array.isArray(value)) return `${shape}, not ${show(value)}.`;
  for (const [index, region] of value.entries()) {
    const { vertices, orientation, ...rest } = (region ?? {}) as Partial<Record<string, unknown>>;
    if (!Array.isArray(vertices)) return `${shape}; region ${index} has no list of vertices.`;
    const [stranger] = Object.keys(rest);
    if (stranger !== undefined) return `${shape}; region ${index} has an entry “${stranger}” too many.`;
    const what = verticesProblem(vertices, ` of region ${index}`);
    if (what !== undefined) return what;
    if (!isQuaternion(orientation))
      return `must have as orientation ${quaternion}; that of region ${index} is ${show(orientation)}.`;
  }
  return undefined;
}

function scalarsProblem({ min, max }: ScalarsParameter, value: unknown): string | undefined {
  if (!Array.isArray(value) && !(value instanceof Float64Array)) {
    return `must be a list of numbers from ${min} to ${max}, one for each vertex, not ${show(value)}.`;
  }
  const isRight = isWithin(min, max);
  const bad = (value as readonly unknown[]).findIndex((entry) => !isRight(entry));
  return bad < 0
    ? undefined
    : `must hold numbers from ${min} to ${max}; entry ${bad} is ${show(value[bad])}.`;
}

/** Whether its numbers make sense is for the core. */
function styleProblem({ mapping }: StyleParameter, value: unknown): string | undefined {
  if (typeof value === 'string' && value !== '') return undefined;
  if (Array.isArray(value)) return directionsProblem(value);
  const { kind, normals, points, triangles, per } = (value ?? {}) as Partial<Record<string, unknown>>;
  const hasNormals = normals instanceof Float64Array && normals.length % 3 === 0;
  if (kind === 'closest' && hasNormals) return undefined;
  if (kind === 'sphere' && mapping === 'closest')
    return 'must hold directions: those of a convex shape, or a list of normals; a style on the sphere has too many.';
  const hasSphere = points instanceof Float64Array && triangles instanceof Uint32Array;
  if (kind === 'sphere' && hasNormals && hasSphere && (per === 'vertex' || per === 'face')) return undefined;
  return `must name a primitive, a style mesh or a file, or be a list of directions or a Gauss map, not ${show(value)}.`;
}

function directionsProblem(value: readonly unknown[], what = 'directions'): string | undefined {
  const bad = value.findIndex((entry) => !isPoint(entry) || entry.every((part) => part === 0));
  if (value.length > 0 && bad < 0) return undefined;
  const found = bad < 0 ? 'it is empty' : `entry ${bad} is ${show(value[bad])}`;
  return `must list ${what} [x, y, z] of finite numbers, not all of them zero; ${found}.`;
}

function reliefProblem(value: unknown): string | undefined {
  if (typeof value === 'string' && value !== '') return undefined;
  const { uvs, slopes } = (value ?? {}) as Partial<Record<string, unknown>>;
  if (uvs instanceof Float32Array && slopes instanceof Float32Array && uvs.length === slopes.length)
    return undefined;
  return `must name a picture or a pattern, or be a relief, not ${show(value)}.`;
}

function handlesProblem(value: unknown): string | undefined {
  const shape = 'must be {"vertices": [index, …], "targets": [[x, y, z], …]}';
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    return `${shape}, not ${show(value)}.`;
  const { vertices, targets, ...rest } = value as { vertices?: unknown; targets?: unknown };
  if (!Array.isArray(vertices) || !Array.isArray(targets)) return `${shape}; both lists are needed.`;
  const [stranger] = Object.keys(rest);
  if (stranger !== undefined) return `${shape}; it has an entry “${stranger}” too many.`;
  if (vertices.length !== targets.length) {
    return `must have as many targets as vertices; there are ${vertices.length} vertices and ${targets.length} targets.`;
  }
  const badVertices = verticesProblem(vertices);
  if (badVertices !== undefined) return badVertices;
  const badTarget = targets.findIndex((target) => !isPoint(target));
  if (badTarget >= 0) {
    return `must have targets [x, y, z] of finite numbers; entry ${badTarget} is ${show(targets[badTarget])}.`;
  }
  return undefined;
}

function verticesProblem(vertices: readonly unknown[], where = ''): string | undefined {
  const bad = vertices.findIndex((vertex) => !Number.isInteger(vertex) || (vertex as number) < 0);
  if (bad < 0) return undefined;
  return `must name vertices by whole numbers from 0; entry ${bad}${where} is ${show(vertices[bad])}.`;
}

function isPoint(value: unknown, size = 3): value is readonly number[] {
  return Array.isArray(value) && value.length === size && value.every((entry) => Number.isFinite(entry));
}

/** A value as a person may recognise it, cut short. JSON has no NaN or Infinity, hence the detour for numbers. */
function show(value: unknown): string {
  if (typeof value === 'number') return String(value);
  const text = JSON.stringify(value, (_, entry) =>
    typeof entry === 'number' && !Number.isFinite(entry) ? String(entry) : entry,
  );
  if (text === undefined) return String(value);
  return text.length > 60 ? `${text.slice(0, 57)}…` : text;
}

function problem(code: ParameterProblem['code'], parameter: string, message: string): ParameterProblem {
  return { code, parameter, message };
}
