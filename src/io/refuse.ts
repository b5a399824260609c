import { type FailureCode, WhittleError } from '../mesh/failure.ts';

/**
 * An error about a file: "cow.obj, line 812: the face uses vertex 9041, but …".
 *
 * @param place "line 812", "accessor 3", or '' for the file as a whole
 */
export function refusal(
  code: FailureCode,
  name: string,
  place: string,
  sentence: string,
  element?: number,
): WhittleError {
  const file = name === '' ? 'The file' : name;
  return new WhittleError(code, `${file}${place === '' ? '' : `, ${place}`}: ${sentence}`, element);
}

/** A piece of a file, short and printable, for use in a sentence. */
export function quote(text: string): string {
  const short = text.length > 24 ? `${text.slice(0, 24)}…` : text;
  return JSON.stringify(short);
}

/** "1 face", "3 faces". */
export function counted(count: number, singular: string, plural = `${singular}s`): string {
  return `${count} ${count === 1 ? singular : plural}`;
}
