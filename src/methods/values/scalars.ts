import { WhittleError } from '../../mesh/failure.ts';
import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { isWithin } from './points.ts';
import { show } from './show.ts';

/** A number for each vertex, by the source file's position list. */
export type Scalars = readonly number[] | Float64Array;

/** {@link Scalars}; absent or empty means none. */
export interface ScalarsParameter extends Parameter {
  readonly kind: 'scalars';
  /** Hard range of each number, inclusive. */
  readonly min: number;
  readonly max: number;
}

export const scalars: ValueKind<ScalarsParameter, Scalars> = {
  problem({ min, max }, value) {
    if (!Array.isArray(value) && !(value instanceof Float64Array)) {
      return `must be a list of numbers from ${min} to ${max}, one for each vertex, not ${show(value)}.`;
    }
    const isRight = isWithin(min, max);
    const bad = (value as readonly unknown[]).findIndex((entry) => !isRight(entry));
    if (bad < 0) return undefined;
    return `must hold numbers from ${min} to ${max}; entry ${bad} is ${show(value[bad])}.`;
  },
  /** Places that the file stores several times have the mean of their numbers. */
  encode({ name }, values, { vertexOfPosition, positionOfVertex }) {
    const count = vertexOfPosition.length;
    if (values.length === 0) return encodedNumbers([]);
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
    return encodedNumbers(sums.map((sum, vertex) => sum / visits[vertex]!));
  },
  help: ({ min, max }) => ({ value: 'FILE.json', range: `[number, …] from ${min} to ${max}, default none` }),
};
