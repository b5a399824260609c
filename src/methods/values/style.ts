import { WhittleError } from '../../mesh/failure.ts';
import type { GaussMap } from './gauss-map.ts';
import { type Encoded, noIndices, type Parameter, type ValueKind } from './parameter.ts';
import { type Directions, directionsProblem } from './points.ts';
import { show } from './show.ts';

/** A primitive ('cube'), a style mesh ('oloid') or the path of a mesh file. */
export type StyleName = string;

/**
 * A style. In a recipe or on the command line a {@link StyleName} or {@link Directions}, which `readStyle` of `src/inputs`
 * turns into the {@link GaussMap} that the engine takes.
 */
export interface StyleParameter extends Parameter {
  readonly kind: 'style';
  /** Set where only a few directions will do: those of a convex shape, or a list of them. */
  readonly mapping?: 'closest';
  /** What page and command line take when nothing is said; the engine itself has none. */
  readonly default: string;
}

export const style: ValueKind<StyleParameter, StyleName | Directions | GaussMap> = {
  /** Whether its numbers make sense is for the core. */
  problem({ mapping }, value) {
    if (typeof value === 'string' && value !== '') return undefined;
    if (Array.isArray(value)) return directionsProblem(value);
    const { kind, normals, points, triangles, per } = (value ?? {}) as Partial<Record<string, unknown>>;
    const hasNormals = normals instanceof Float64Array && normals.length % 3 === 0;
    if (kind === 'closest' && hasNormals) return undefined;
    if (kind === 'sphere' && mapping === 'closest')
      return 'must hold directions: those of a convex shape, or a list of normals; a style on the sphere has too many.';
    const hasSphere = points instanceof Float64Array && triangles instanceof Uint32Array;
    if (kind === 'sphere' && hasNormals && hasSphere && (per === 'vertex' || per === 'face'))
      return undefined;
    return `must name a primitive, a style mesh or a file, or be a list of directions or a Gauss map, not ${show(value)}.`;
  },
  encode({ name }, value) {
    if (typeof value === 'string' || isDirections(value)) throw unresolved(name, value);
    return encodeGaussMap(value);
  },
  help: ({ default: usual }) => ({
    value: 'NAME|FILE',
    range: `a FILE.json lists [[x, y, z], …]; default ${usual}`,
  }),
  takesNames: true,
  fromText: (text) => text,
  isFile: () => false,
};

function encodeGaussMap(map: GaussMap): Encoded {
  if (map.kind === 'closest') return { name: 'closest', numbers: map.normals, indices: noIndices };
  const { points, normals, triangles, per } = map;
  const numbers = new Float64Array(points.length + normals.length);
  numbers.set(points);
  numbers.set(normals, points.length);
  const indices = new Uint32Array(1 + triangles.length);
  indices[0] = points.length / 3;
  indices.set(triangles, 1);
  return { name: per, numbers, indices };
}

function isDirections(value: Directions | GaussMap): value is Directions {
  return Array.isArray(value);
}

function unresolved(name: string, value: string | Directions): WhittleError {
  const what = typeof value === 'string' ? `the name “${value}”` : 'a list of directions';
  return new WhittleError(
    'bad-parameter',
    `“${name}” is ${what}, but the engine takes a Gauss map itself; make one with resolveStyle first.`,
  );
}
