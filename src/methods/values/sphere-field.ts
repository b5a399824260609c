import { WhittleError } from '../../mesh/failure.ts';
import type { Parameter, ValueKind } from './parameter.ts';
import { isWithin } from './points.ts';
import { show } from './show.ts';

/**
 * Numbers from 0 to 1 over the sphere of directions, as a picture of it: equirectangular, twice as wide as high, y up.
 *
 * The centre of the pixel in column i and row j, rows from the top, is the direction (sin θ sin φ, cos θ, sin θ cos φ) with
 * θ = π (j + ½) / height and φ = 2π ((i + ½) / width − ½): +z is in the middle, +x right of it, +y along the top edge. Between
 * centres it is bilinear, over the left and right edge and over the poles too.
 */
export interface SphereField {
  /** Twice the height. */
  readonly width: number;
  /** From 2 to 1024. */
  readonly height: number;
  /** 0 to 1, rows from the top, width·height numbers. */
  readonly values: readonly number[] | Float64Array;
}

/** The path of a PNG. */
export type SphereFieldName = string;

/**
 * A field on the Gauss map. In a recipe or on the command line a {@link SphereFieldName}, which `src/inputs/fields` turns into
 * the {@link SphereField} that the engine takes, or such a field itself. Absent means 1 everywhere.
 */
export interface SphereFieldParameter extends Parameter {
  readonly kind: 'sphereField';
}

const leastHeight = 2;
const mostHeight = 1024;

/** What is wrong with the size of a picture of the sphere, in pixels. */
export function sphereSizeProblem(width: number, height: number): string | undefined {
  if (width === 2 * height && height >= leastHeight && height <= mostHeight) return undefined;
  return `must be twice as wide as high, from ${2 * leastHeight} × ${leastHeight} to ${2 * mostHeight} × ${mostHeight}, not ${width} × ${height}.`;
}

export const sphereField: ValueKind<SphereFieldParameter, SphereFieldName | SphereField> = {
  problem(_, value) {
    if (typeof value === 'string' && value !== '') return undefined;
    const shape = 'must name a PNG or be {"width": 2·height, "height": number, "values": [number, …]}';
    if (typeof value !== 'object' || value === null || Array.isArray(value))
      return `${shape}, not ${show(value)}.`;
    const { width, height, values, ...rest } = value as Partial<Record<string, unknown>>;
    if (!Number.isInteger(width) || !Number.isInteger(height))
      return `${shape}; width and height are needed, as whole numbers.`;
    const [stranger] = Object.keys(rest);
    if (stranger !== undefined) return `${shape}; it has an entry “${stranger}” too many.`;
    const size = sphereSizeProblem(width as number, height as number);
    if (size !== undefined) return size;
    const count = (width as number) * (height as number);
    const list = Array.isArray(values) || values instanceof Float64Array ? (values as unknown[]) : undefined;
    if (list?.length !== count)
      return `must have ${count} values, one for each pixel; it has ${list?.length ?? 'none'}.`;
    const bad = list.findIndex((entry) => !isWithin(0, 1)(entry));
    if (bad < 0) return undefined;
    return `must hold numbers from 0 to 1; value ${bad} is ${show(list[bad])}.`;
  },
  encode({ name }, value) {
    if (typeof value === 'string') {
      throw new WhittleError(
        'bad-parameter',
        `“${name}” is the name “${value}”, but the engine takes a field itself; make one with readSphereField first.`,
      );
    }
    const { width, height, values } = value;
    return { name: '', numbers: Float64Array.from(values), indices: Uint32Array.of(width, height) };
  },
  help: () => ({
    value: 'FILE.png|FILE.json',
    range: 'a grey picture of the sphere, 2:1, white 1 and black 0; default 1 everywhere',
  }),
  takesNames: true,
  fromText: (text) => text,
  isFile: (_, text) => /\.json$/i.test(text),
};
