import { viewOf } from '../bytes.ts';
import { newFaceNormals } from '../normals.ts';
import { firstThree, normalTexts, positionTexts, TextPatch } from '../text-patch.ts';
import { stlFacet, stlHeader } from './facet-count.ts';
import type { StlTextFile } from './scan-ascii.ts';
import type { StlBinaryFile } from './scan-binary.ts';

/** Gives an ASCII STL back with other positions; the normals of facets that have moved follow. */
export function patchStlText(
  source: Uint8Array,
  file: StlTextFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  const patch = new TextPatch(source);
  const normals = facetNormals(file, positions);
  const { start } = file.faces;
  for (let f = 0; f + 1 < start.length; f++) {
    if (!Number.isNaN(normals[3 * f]))
      patch.row(file.normalOffsets[f], firstThree, normalTexts(file.facetNormals, normals, f));
    for (let p = start[f]; p < start[f + 1]; p++) {
      const texts = positionTexts(file.positions, positions, p);
      if (texts.some((text) => text !== undefined)) patch.row(file.positionOffsets[p], firstThree, texts);
    }
  }
  return patch.take();
}

/**
 * Gives a binary STL back with other positions, rounded to 32 bits; header, attributes and what follows stay. A count of facets
 * that was wrong is right in the result.
 */
export function patchStlBinary(
  source: Uint8Array,
  file: StlBinaryFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  const result = new Uint8Array(source);
  const view = viewOf(result);
  view.setUint32(80, positions.length / 9, true);
  const normals = facetNormals(file, positions);
  for (let f = 0; 9 * f < positions.length; f++) {
    const offset = stlHeader + stlFacet * f;
    for (let i = 0; i < 9; i++) {
      if (positions[9 * f + i] !== file.positions[9 * f + i]) {
        view.setFloat32(offset + 12 + 4 * i, positions[9 * f + i], true);
      }
    }
    if (Number.isNaN(normals[3 * f])) continue;
    for (let axis = 0; axis < 3; axis++) view.setFloat32(offset + 4 * axis, normals[3 * f + axis], true);
  }
  return result;
}

/** New facet normals. Facets whose normal is (0, 0, 0), STL's "work it out yourself", keep it. */
function facetNormals(file: StlTextFile | StlBinaryFile, positions: Float64Array): Float64Array {
  const stored = file.facetNormals;
  const normals = newFaceNormals(file.faces, file.positions, positions, stored);
  for (let i = 0; i < stored.length; i += 3) {
    if (stored[i] === 0 && stored[i + 1] === 0 && stored[i + 2] === 0) normals.fill(Number.NaN, i, i + 3);
  }
  return normals;
}
