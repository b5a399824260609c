import { WhittleError } from '../../mesh/failure.ts';
import type { Weld } from '../../mesh/weld.ts';
import type {
  Directions,
  Handles,
  MethodDescriptor,
  ParameterValues,
  Regions,
  Scalars,
} from '../descriptor.ts';
import { weldRegions } from './regions.ts';

type Point = Handles['targets'][number];

/**
 * Parameters as the core takes them: handles, numbers by vertex and regions are those of welded vertices, everything else stays.
 *
 * @throws WhittleError `bad-handles`, its element the source vertex: no such vertex, or two targets for one place;
 *   `bad-parameter`: more or fewer numbers than vertices, regions that overlap or name no vertex, or the mere name of a style, its directions or a picture
 */
export function toWelded(method: MethodDescriptor, parameters: ParameterValues, mesh: Weld): ParameterValues {
  const welded = { ...parameters };
  for (const { name, kind } of method.parameters) {
    const value = parameters[name];
    if (kind === 'handles' && value !== undefined) welded[name] = weldHandles(name, value as Handles, mesh);
    if (kind === 'scalars' && value !== undefined) welded[name] = weldScalars(name, value as Scalars, mesh);
    if (kind === 'rotations' && value !== undefined) welded[name] = weldRegions(name, value as Regions, mesh);
    if (kind === 'style' && (typeof value === 'string' || Array.isArray(value)))
      throw unresolved(name, value, 'a Gauss map', 'resolveStyle');
    if (kind === 'relief' && typeof value === 'string') throw unresolved(name, value, 'a relief', 'reliefOf');
  }
  return welded;
}

/** Places that the file stores several times have the mean of their numbers. */
function weldScalars(
  name: string,
  values: Scalars,
  { vertexOfPosition, positionOfVertex }: Weld,
): Float64Array {
  const count = vertexOfPosition.length;
  if (values.length === 0) return new Float64Array();
  if (values.length !== count) {
    throw new WhittleError(
      'bad-parameter',
      `“${name}” has ${values.length} numbers, but the file has ${count} vertices; give one for each, in the file’s order.`,
    );
  }
  const sums = new Float64Array(positionOfVertex.length);
  const visits = new Float64Array(sums.length);
  vertexOfPosition.forEach((vertex, position) => {
    sums[vertex]! += values[position]!;
    visits[vertex]! += 1;
  });
  return sums.map((sum, vertex) => sum / visits[vertex]!);
}

function unresolved(name: string, value: string | Directions, thing: string, maker: string): WhittleError {
  const what = typeof value === 'string' ? `the name “${value}”` : 'a list of directions';
  return new WhittleError(
    'bad-parameter',
    `“${name}” is ${what}, but the engine takes ${thing} itself; make one with ${maker} first.`,
  );
}

/** Handles that say the same of the same place become one; positions that the file stores twice can only move together. */
function weldHandles(name: string, { vertices, targets }: Handles, mesh: Weld): Handles {
  const handles = new Map<number, { source: number; target: Point }>();
  const count = mesh.vertexOfPosition.length;
  vertices.forEach((source, entry) => {
    const vertex = mesh.vertexOfPosition[source];
    if (vertex === undefined) {
      throw new WhittleError(
        'bad-handles',
        `“${name}” names vertex ${source}, but the file has ${count} vertices (0 to ${count - 1}).`,
        source,
      );
    }
    const target = targets[entry]!;
    const earlier = handles.get(vertex);
    if (!earlier) handles.set(vertex, { source, target });
    else if (!samePoint(earlier.target, target)) throw twoTargets(name, earlier.source, source);
  });
  return {
    vertices: [...handles.keys()],
    targets: [...handles.values()].map(({ target }) => target),
  };
}

function twoTargets(name: string, first: number, second: number): WhittleError {
  const message =
    first === second
      ? `“${name}” gives vertex ${second} two different targets; keep one.`
      : `“${name}” gives vertices ${first} and ${second} different targets, but they are the same point of the surface ` +
        '(the file stores it twice, along a seam); give both the same target or keep one.';
  return new WhittleError('bad-handles', message, second);
}

function samePoint(a: Point, b: Point): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}
