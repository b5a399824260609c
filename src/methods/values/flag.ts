import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { show } from './show.ts';

/** Something that is done or not. */
export interface FlagParameter extends Parameter {
  readonly kind: 'flag';
  readonly default: boolean;
}

export const flag: ValueKind<FlagParameter, boolean> = {
  problem: (_, value) =>
    typeof value === 'boolean' ? undefined : `must be true or false, not ${show(value)}.`,
  encode: (_, value) => encodedNumbers([value ? 1 : 0]),
  help: ({ default: usual }) => ({ value: '', range: `alone for true, or =true, =false; default ${usual}` }),
  fromText: (text) => (text === 'true' || text === 'false' ? text === 'true' : text),
};
