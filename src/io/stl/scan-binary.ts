import { viewOf } from '../bytes.ts';
import { type ParsedFile, triangleFaces } from '../parsed-file.ts';
import { counted, refusal } from '../refuse.ts';
import { countFacets, stlFacet, stlHeader } from './facet-count.ts';

/** A binary STL. Positions are not shared: each corner has its own. */
export interface StlBinaryFile extends ParsedFile {
  /** #F×3 as the file has them, whatever they are. */
  readonly facetNormals: Float64Array;
}

/**
 * Reads binary STL.
 *
 * @throws no-faces, truncated-file, not-finite
 */
export function scanStlBinary(bytes: Uint8Array, name: string): StlBinaryFile {
  const view = viewOf(bytes);
  const { count, correction } = countFacets(bytes, name);
  const positions = new Float64Array(9 * count);
  const facetNormals = new Float64Array(3 * count);
  for (let f = 0; f < count; f++) {
    const offset = stlHeader + stlFacet * f;
    for (let axis = 0; axis < 3; axis++)
      facetNormals[3 * f + axis] = view.getFloat32(offset + 4 * axis, true);
    for (let i = 0; i < 9; i++) {
      const value = view.getFloat32(offset + 12 + 4 * i, true);
      if (value - value !== 0) throw notFinite(name, f, value);
      positions[9 * f + i] = value;
    }
  }
  const corners = new Uint32Array(3 * count);
  for (let c = 0; c < corners.length; c++) corners[c] = c;
  const extra = bytes.length - stlHeader - stlFacet * count;
  const warnings = correction === undefined ? [] : [correction];
  if (extra > 0) warnings.push(`Ignored ${counted(extra, 'byte')} behind the last facet.`);
  return { positions, faces: triangleFaces(corners), warnings, facetNormals };
}

function notFinite(name: string, facet: number, value: number): Error {
  const sentence = `a corner has the coordinate ${value}; repair the mesh where you made it and export it again.`;
  return refusal('not-finite', name, `facet ${facet + 1}`, sentence, facet);
}
