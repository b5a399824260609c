import { numbersOf } from './number.ts';
import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { isWithin } from './points.ts';
import { show } from './show.ts';

/** A fixed count of numbers, as many as its default has. */
export interface VectorParameter extends Parameter {
  readonly kind: 'vector';
  readonly default: readonly number[];
  /** Hard range of each number, inclusive. */
  readonly min: number;
  readonly max: number;
}

export const vector: ValueKind<VectorParameter, readonly number[]> = {
  problem({ default: usual, min, max }, value) {
    const isRight = Array.isArray(value) && value.length === usual.length && value.every(isWithin(min, max));
    if (isRight) return undefined;
    return `must be ${usual.length} numbers from ${min} to ${max}, such as [${usual.join(', ')}], not ${show(value)}.`;
  },
  encode: (_, value) => encodedNumbers(value),
  help: ({ min, max, default: usual }) => ({
    value: usual.map(() => 'N').join(),
    range: `${min} to ${max}, default ${usual.join()}`,
  }),
  fromText: numbersOf,
};
