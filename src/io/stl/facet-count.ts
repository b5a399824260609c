import { viewOf } from '../bytes.ts';
import { counted, refusal } from '../refuse.ts';

/** Header and count, then for each facet a normal, three corners and two bytes of attributes. */
export const stlHeader = 84;
export const stlFacet = 50;

/** How many facets a binary STL has. */
export interface FacetCount {
  readonly count: number;
  /** The header has another number, and this is what to say of it. */
  readonly correction?: string;
}

/**
 * Programs that write facets as they come may leave the count at 0 or 0xFFFFFFFF, or get it wrong; then the length of the file
 * decides, as it does in slicers. A count that fits, with bytes behind it that are no facets, is right.
 *
 * @throws no-faces, truncated-file
 */
export function countFacets(bytes: Uint8Array, name: string): FacetCount {
  if (bytes.length < stlHeader) {
    const sentence = 'the file ends inside its header; it was cut off. Export it again.';
    throw refusal('truncated-file', name, `byte ${bytes.length}`, sentence);
  }
  const said = saidCount(bytes);
  const held = heldCount(bytes);
  const tail = bytes.length - stlHeader - stlFacet * held;
  if (said === held && held > 0) return { count: held };
  if (held === 0) throw refusal('no-faces', name, 'byte 80', 'the file has no facets; export it again.');
  if (said > 0 && said < held && (tail > 0 || !areFacets(bytes, said, held))) return { count: said };
  if ((tail > 0 && !isPlaceholder(said)) || !areFacets(bytes, 0, held)) {
    const sentence = `the header promises ${counted(said, 'facet')}, but the file holds only ${held}; it was cut off. Export it again.`;
    throw refusal('truncated-file', name, `byte ${bytes.length}`, sentence);
  }
  return { count: held, correction: correction(said, held) };
}

/** Whether the length of a file is exactly that of the facets that its header promises. */
export function hasFacetLength(bytes: Uint8Array): boolean {
  return bytes.length >= stlHeader && bytes.length === stlHeader + stlFacet * saidCount(bytes);
}

/**
 * Whether bytes that are no text may be a binary STL: a header of text (a cut-off file then gets the right sentence), or facets
 * where they ought to be.
 */
export function looksLikeFacets(bytes: Uint8Array): boolean {
  if (bytes.length < stlHeader) return false;
  let textual = 0;
  for (let at = 0; at < 80; at++) if (bytes[at] === 0 || (bytes[at] >= 32 && bytes[at] < 127)) textual++;
  if (textual >= 70) return true;
  const said = saidCount(bytes);
  const held = heldCount(bytes);
  const isWhole = bytes.length === stlHeader + stlFacet * held;
  const count = said > 0 && said <= held ? said : isWhole || isPlaceholder(said) ? held : 0;
  return count > 0 && areFacets(bytes, 0, count);
}

function correction(said: number, held: number): string {
  const what = isPlaceholder(said)
    ? 'does not say how many facets follow'
    : `counts ${counted(said, 'facet')}`;
  const cut = said > held && !isPlaceholder(said) ? ' If parts are missing, the file was cut off.' : '';
  return `The header ${what}, but the file holds ${held}: all are read, and the count is right in what is written.${cut}`;
}

function isPlaceholder(said: number): boolean {
  return said === 0 || said >= 0x7fffffff;
}

function saidCount(bytes: Uint8Array): number {
  return viewOf(bytes).getUint32(80, true);
}

function heldCount(bytes: Uint8Array): number {
  return Math.floor((bytes.length - stlHeader) / stlFacet);
}

/** Beyond these sizes numbers are no measures of a thing; text and other data read as numbers mostly are. */
const smallest = 1e-30;
const largest = 1e15;

/** Whether the facets [from, to) could be some: all coordinates finite and of a sane size, and not all of them zero. */
function areFacets(bytes: Uint8Array, from: number, to: number): boolean {
  const view = viewOf(bytes);
  let isSomewhere = false;
  for (let f = from; f < to; f++) {
    for (let i = 0; i < 9; i++) {
      const size = Math.abs(view.getFloat32(stlHeader + stlFacet * f + 12 + 4 * i, true));
      if (size === 0) continue;
      if (!(size > smallest && size < largest)) return false;
      isSomewhere = true;
    }
  }
  return isSomewhere;
}
