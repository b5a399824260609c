import { refusal } from '../refuse.ts';
import { TextScanner } from '../text-scanner.ts';

/** What the first word of an OFF file says of its vertices. */
export interface OffKeyword {
  readonly hasUvs: boolean;
  readonly hasColors: boolean;
  readonly hasNormals: boolean;
  /** Vertices of four or any number of coordinates. */
  readonly hasOtherDimensions: boolean;
  /** Length of the keyword; the number of vertices may be glued to it. */
  readonly length: number;
}

const lf = 10;

/**
 * Understands the first word of a file: texture coordinates, colours, normals, four dimensions, any dimensions. Capitals or small
 * letters; `n` (any dimensions) differs from `N` (normals) where the rest is in capitals.
 */
export function offKeyword(word: string): OffKeyword | undefined {
  const found =
    /^(ST)?(C)?(N)?(4)?(n)?OFF(?=\d*$)/.exec(word) ?? /^(st)?(c)?(n)?(4)?()off(?=\d*$)/i.exec(word);
  if (!found) return undefined;
  const [{ length }, uvs, colors, normals, four, any] = found;
  return {
    hasUvs: !!uvs,
    hasColors: !!colors,
    hasNormals: !!normals,
    hasOtherDimensions: !!four || !!any,
    length,
  };
}

/**
 * Whether a text is an OFF file without its keyword: a line of two or three whole numbers, and behind it at least as many numbers
 * as that many vertices and triangles take.
 */
export function isBareOff(bytes: Uint8Array): boolean {
  const scanner = new TextScanner(bytes, '');
  const counts: number[] = [];
  for (scanner.peek(); scanner.peekInLine() !== lf && counts.length < 4; ) counts.push(scanner.decimal());
  const [vertices, faces, edges = 0] = counts;
  const areCounts = [vertices, faces, edges].every((count) => Number.isInteger(count) && count >= 0);
  if (!areCounts || counts.length > 3 || vertices < 3 || faces < 1) return false;
  let missing = 3 * vertices + 4 * faces;
  for (; missing > 0 && scanner.peek() >= 0; missing--) if (Number.isNaN(scanner.decimal())) return false;
  return missing === 0;
}

/** Refuses what is no plain OFF in text. */
export function refuseOffKind(kind: string, name: string, place: string): Error {
  return refusal('unsupported-file', name, place, `${kind} is not read; export plain OFF, OBJ or PLY.`);
}
