import { newNormals } from '../normals.ts';
import { hasMoved, normalTexts, positionTexts, TextPatch } from '../text-patch.ts';
import type { OffFile } from './scan.ts';

const columns: readonly number[] = [0, 1, 2, 3, 4, 5];

/** Gives an OFF file back with other positions and vertex normals; colours, comments and faces stay. */
export function patchOff(
  source: Uint8Array,
  file: OffFile,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  const patch = new TextPatch(source);
  const stored = { values: file.normals, ofCorner: file.faces.corners };
  const hasNormals = file.normals.length > 0;
  const normals = hasNormals ? newNormals(file.faces, file.positions, positions, stored) : undefined;
  for (let p = 0; p < file.positionOffsets.length; p++) {
    const turned = normals !== undefined && !Number.isNaN(normals[3 * p]);
    if (!turned && !hasMoved(file.positions, positions, p)) continue;
    const texts = positionTexts(file.positions, positions, p);
    if (turned) texts.push(...normalTexts(file.normals, normals, p));
    patch.row(file.positionOffsets[p], columns.slice(0, texts.length), texts);
  }
  return patch.take();
}
