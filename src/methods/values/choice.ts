import { encodedNumbers, noIndices, noNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { type Directions, directionsProblem } from './points.ts';
import { show } from './show.ts';

/** One of several names, or, where rows will do in place of a name, {@link Directions} whose lengths count. */
export interface ChoiceParameter extends Parameter {
  readonly kind: 'choice';
  readonly default: string;
  readonly choices: readonly string[];
  /** What a person reads in their place. Default: the names themselves. */
  readonly labels?: Readonly<Record<string, string>>;
  /** Its choices are best understood side by side on the mesh at hand. */
  readonly toCompare?: true;
  /** Set where a list of rows will do: how many at most. Whether their lengths make sense is for the core. */
  readonly maxRows?: number;
  /** The rows that names stand for; for pictures, and to begin rows of one's own with. */
  readonly rows?: Readonly<Record<string, Directions>>;
}

export const choice: ValueKind<ChoiceParameter, string | Directions> = {
  problem({ choices, maxRows = 0 }, value) {
    if (choices.includes(value as string)) return undefined;
    if (maxRows > 0 && Array.isArray(value)) {
      if (value.length <= maxRows) return directionsProblem(value, 'rows');
      return `must have ${maxRows} rows at most; it has ${value.length}.`;
    }
    const rows = maxRows > 0 ? `, or a list of ${maxRows} rows [x, y, z] at most` : '';
    return `must be one of ${choices.join(', ')}${rows}, not ${show(value)}.`;
  },
  encode: (_, value) =>
    typeof value === 'string'
      ? { name: value, numbers: noNumbers, indices: noIndices }
      : encodedNumbers(value.flat()),
  help({ choices, maxRows, default: usual }) {
    const range = `${choices.join(' | ')}, default ${usual}`;
    if (!maxRows) return { value: 'NAME', range };
    return {
      value: 'NAME|FILE.json',
      range: `${range}; a FILE.json lists ${maxRows} rows [x, y, z] at most`,
    };
  },
  fromText: (text) => text,
  isFile: ({ maxRows }, text) => Boolean(maxRows) && /\.json$/i.test(text),
};
