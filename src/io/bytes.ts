/** Small questions about the bytes of a text file. */

/** Whether a text begins with the mark of UTF-8. */
export function hasByteOrderMark(bytes: Uint8Array): boolean {
  return bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
}

/** Length of the line end at `at`: 2 for CR LF, 1 for LF or CR, else 0. */
export function lineEndLength(bytes: Uint8Array, at: number): number {
  const c = bytes[at];
  if (c === 10) return 1;
  if (c === 13) return bytes[at + 1] === 10 ? 2 : 1;
  return 0;
}

/** Whether a word cannot go on at `at`: blank, line end, continuation or end of file. */
export function isTokenEnd(bytes: Uint8Array, at: number): boolean {
  if (at >= bytes.length) return true;
  const c = bytes[at];
  return c <= 32 || (c === 92 && lineEndLength(bytes, at + 1) > 0);
}

export function tokenEnd(bytes: Uint8Array, at: number): number {
  let end = at;
  while (!isTokenEnd(bytes, end)) end++;
  return end;
}

/** Bytes as characters of the same code; for words and numbers, which are ASCII where it matters. */
export function decodeAscii(bytes: Uint8Array, from: number, to: number): string {
  let text = '';
  for (let at = from; at < to; at++) text += String.fromCharCode(bytes[at]);
  return text;
}

export function encodeUtf8(text: string): Uint8Array<ArrayBuffer> {
  return new TextEncoder().encode(text);
}

/** A view that is surely a plain `Uint8Array` (Node's `Buffer` slices differently). */
export function plainBytes(bytes: Uint8Array): Uint8Array {
  return new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

export function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** Pieces one after the other. */
export function concatenate(pieces: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const result = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    result.set(piece, at);
    at += piece.length;
  }
  return result;
}
