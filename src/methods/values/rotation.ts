import { numbersOf } from './number.ts';
import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { isPoint } from './points.ts';
import { show } from './show.ts';

/** A rotation as glTF and three.js write it, of any length but zero. */
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

export interface RotationParameter extends Parameter {
  readonly kind: 'rotation';
  readonly default: Quaternion;
}

export const rotation: ValueKind<RotationParameter, Quaternion> = {
  problem: (_, value) =>
    isQuaternion(value) ? undefined : `must be ${quaternionInWords}, not ${show(value)}.`,
  encode: (_, value) => encodedNumbers(value),
  help: ({ default: usual }) => ({
    value: 'X,Y,Z,W',
    range: `a quaternion of any length but 0, default ${usual.join()}`,
  }),
  fromText: numbersOf,
};

export const quaternionInWords = 'a quaternion [x, y, z, w] of finite numbers, not all of them zero';

export function isQuaternion(value: unknown): value is Quaternion {
  return isPoint(value, 4) && value.some((part) => part !== 0);
}
