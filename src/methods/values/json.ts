import { WhittleError } from '../../mesh/failure.ts';
import { lineOfJsonError } from './json-error.ts';

/**
 * Reads JSON that a person may have written.
 *
 * @param fileName for the message
 * @throws WhittleError `bad-recipe` with file and line, its element the line from 1
 */
export function parseJson(text: string, fileName: string): unknown {
  try {
    return JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch {
    const line = lineOfJsonError(text.replace(/^\uFEFF/, ''));
    const message = `${fileName}, line ${line}: this is not JSON; look for a missing comma, quote or bracket there.`;
    throw new WhittleError('bad-recipe', message, line);
  }
}

export function isObject(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
