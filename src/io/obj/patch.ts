import { newNormals } from '../normals.ts';
import { firstThree, normalTexts, positionTexts, TextPatch } from '../text-patch.ts';
import type { ObjFile } from './scan.ts';

/** Gives an OBJ file back with other numbers in its `v` and `vn` lines; each number that keeps its value keeps its text. */
export function patchObj(
  source: Uint8Array,
  file: ObjFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  const patch = new TextPatch(source);
  const normals = normalsOf(file, positions);
  const { positionOffsets, normalOffsets } = file;
  let n = 0;
  for (let p = 0; p <= positionOffsets.length; p++) {
    const here = p < positionOffsets.length ? positionOffsets[p] : Number.POSITIVE_INFINITY;
    for (; n < normalOffsets.length && normalOffsets[n] < here; n++) {
      if (normals && !Number.isNaN(normals[3 * n])) {
        patch.row(normalOffsets[n], firstThree, normalTexts(file.normals, normals, n));
      }
    }
    if (p === positionOffsets.length) break;
    const texts = positionTexts(file.positions, positions, p);
    if (texts.some((text) => text !== undefined)) patch.row(here, firstThree, texts);
  }
  return patch.take();
}

function normalsOf(file: ObjFile, positions: Float64Array): Float64Array | undefined {
  if (file.normalOfCorner.length === 0) return undefined;
  const stored = { values: file.normals, ofCorner: file.normalOfCorner };
  return newNormals(file.faces, file.positions, positions, stored);
}
