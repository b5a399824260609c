/** Finds where values stand in a JSON text, so that they can be replaced and the rest kept byte for byte. */

/** Bytes [begin, end) of a value. */
export type Span = readonly [number, number];

const quoteMark = 34;
const backslash = 92;
const openers = new Set([91, 123]);
const closers = new Set([93, 125]);

/**
 * The value of member `key` of the object at `object`, the last one if the key is repeated (as `JSON.parse` has it).
 * The text must be valid JSON.
 */
export function memberSpan(bytes: Uint8Array, object: Span | undefined, key: string): Span | undefined {
  if (!object || bytes[object[0]] !== 123) return undefined;
  let found: Span | undefined;
  for (let at = skipBlanks(bytes, object[0] + 1); bytes[at] === quoteMark; ) {
    const keyEnd = valueEnd(bytes, at);
    const begin = skipBlanks(bytes, skipBlanks(bytes, keyEnd) + 1); // over the colon
    const end = valueEnd(bytes, begin);
    if (isKey(bytes, at, keyEnd, key)) found = [begin, end];
    at = skipBlanks(bytes, end);
    if (bytes[at] !== 44) break;
    at = skipBlanks(bytes, at + 1);
  }
  return found;
}

/** All elements of the array at `array`. */
export function elementSpans(bytes: Uint8Array, array: Span | undefined): Span[] {
  const spans: Span[] = [];
  if (!array || bytes[array[0]] !== 91) return spans;
  let at = skipBlanks(bytes, array[0] + 1);
  while (at < array[1] && bytes[at] !== 93) {
    const end = valueEnd(bytes, at);
    spans.push([at, end]);
    at = skipBlanks(bytes, end);
    if (bytes[at] === 44) at = skipBlanks(bytes, at + 1);
  }
  return spans;
}

/** The value that begins behind the blanks at `at`. */
export function valueSpan(bytes: Uint8Array, at: number): Span {
  const begin = skipBlanks(bytes, at);
  return [begin, valueEnd(bytes, begin)];
}

function skipBlanks(bytes: Uint8Array, from: number): number {
  let at = from;
  while (bytes[at] === 32 || bytes[at] === 9 || bytes[at] === 10 || bytes[at] === 13) at++;
  return at;
}

/** End of the value at `from`. Counts brackets instead of recursing: depth is the file's choice. */
function valueEnd(bytes: Uint8Array, from: number): number {
  let depth = 0;
  let at = from;
  do {
    const c = bytes[at];
    if (c === quoteMark) {
      at = stringEnd(bytes, at);
    } else if (openers.has(c)) {
      depth++;
      at++;
    } else if (closers.has(c)) {
      depth--;
      at++;
    } else if (depth > 0) {
      at++;
    } else {
      while (at < bytes.length && !isLiteralEnd(bytes[at])) at++;
    }
  } while (depth > 0 && at < bytes.length);
  return at;
}

function stringEnd(bytes: Uint8Array, from: number): number {
  let at = from + 1;
  while (at < bytes.length && bytes[at] !== quoteMark) at += bytes[at] === backslash ? 2 : 1;
  return at + 1;
}

function isLiteralEnd(c: number): boolean {
  return c <= 32 || c === 44 || c === 58 || closers.has(c);
}

function isKey(bytes: Uint8Array, begin: number, end: number, key: string): boolean {
  const text = new TextDecoder().decode(bytes.slice(begin, end));
  return text === `"${key}"` || (text.includes('\\') && JSON.parse(text) === key);
}
