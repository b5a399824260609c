import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { isWithin } from './points.ts';
import { show } from './show.ts';

export interface NumberParameter extends Parameter {
  readonly kind: 'number' | 'integer';
  readonly default: number;
  /** Hard range, inclusive; the core refuses what lies outside. */
  readonly min: number;
  readonly max: number;
  /** Unit as shown to people, '' for a pure number. */
  readonly unit: string;
  /** The range that looks good, for sliders. */
  readonly slider?: { readonly min: number; readonly max: number; readonly step: number };
}

/** Numbers, whole ones too. */
export const number: ValueKind<NumberParameter, number> = {
  problem({ kind, min, max }, value) {
    const isWhole = kind === 'number' || Number.isInteger(value);
    if (isWhole && isWithin(min, max)(value)) return undefined;
    const wanted = kind === 'integer' ? 'a whole number' : 'a number';
    return `must be ${wanted} from ${min} to ${max}, not ${show(value)}.`;
  },
  encode: (_, value) => encodedNumbers([value]),
  help({ kind, min, max, unit, default: usual }) {
    const range = `${min} to ${max}${unit && ` ${unit}`}, default ${usual}`;
    return { value: kind === 'number' ? 'NUMBER' : 'COUNT', range };
  },
  fromText: numberOf,
};

/** The number that a text says. What is none stays text. */
export function numberOf(text: string): number | string {
  const value = Number(text);
  return text.trim() === '' || Number.isNaN(value) ? text : value;
}

/** Numbers with commas between them. */
export function numbersOf(text: string): (number | string)[] {
  return text.split(',').map(numberOf);
}
