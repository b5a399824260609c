import { refusal } from './refuse.ts';

/** Whether a number stays finite when it is rounded to 32 bits. */
export function fitsFloat32(value: number): boolean {
  return Number.isFinite(Math.fround(value));
}

/** Why a new position cannot be written. */
export function unfitPosition(name: string, p: number, value: number): Error {
  const sentence = `its new coordinate ${value} cannot be written; undo the last step.`;
  return refusal('not-finite', name, `vertex ${p}`, sentence, p);
}
