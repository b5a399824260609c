import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Relief } from '../../src/methods/relief.ts';
import { findPattern, patternIds } from '../../src/textures/patterns.ts';
import { legibility, reliefOf, tilesAlong, tooFine } from '../../src/textures/relief.ts';
import type { Texture } from '../../src/textures/texture.ts';
import type { ChosenPicture } from './document.ts';

/** A picture that can be clicked. */
export interface PictureEntry {
  /** Unique on the page. */
  readonly id: string;
  readonly name: string;
  /** As recipes and the command line call it. */
  readonly source: string;
  /** Brought by the person. */
  readonly isOwn: boolean;
  /** Made when first asked for. */
  readonly texture: () => Texture;
}

/** The patterns that come with the page. */
export const builtInPictures: readonly PictureEntry[] = patternIds.map((id) => ({
  id: `pattern-${id}`,
  name: id.charAt(0).toUpperCase() + id.slice(1),
  source: id,
  isOwn: false,
  texture: () => findPattern(id)!,
}));

let brought = 0;

/** A picture of the person's own. */
export function ownPicture(file: string, texture: Texture): PictureEntry {
  const name = file.replace(/\.[^.]*$/, '') || file;
  return { id: `own-picture-${++brought}`, name, source: file, isOwn: true, texture: () => texture };
}

/** So many of a pattern's tiles along the mesh look right. */
const usualTiles = 3;
const mostRepeats = 8;
/** Fewer where the mesh could not show them: so much of the relief must be left. */
const wellShown = 0.7;

/** How often a picture comes at first: a pattern as its look asks for; one of one's own was made for the mesh and comes once. */
export function startingRepeat({ isPattern, texture }: ChosenPicture, mesh: Mesh): number {
  if (!isPattern || !mesh.uvs) return 1;
  let repeat = Math.min(mostRepeats, Math.max(1, Math.round(usualTiles / tilesAlong(mesh))));
  while (repeat > 1 && legibility(texture, mesh, { repeat }).kept < wellShown) repeat--;
  return repeat;
}

interface Laid {
  readonly mesh: Mesh;
  readonly repeat: number;
  readonly relief: Relief;
  readonly remark: string | undefined;
}

/** How each picture was last laid on a mesh: its strength and all else changes far more often. */
const latest = new WeakMap<Texture, Laid>();

/** A picture on a mesh, and what there is to say of it. @throws WhittleError as `reliefOf` */
export function laid({ texture }: ChosenPicture, mesh: Mesh, repeat: number): Laid {
  const known = latest.get(texture);
  if (known?.mesh === mesh && known.repeat === repeat) return known;
  const relief = reliefOf(texture, mesh, { repeat });
  const now = { mesh, repeat, relief, remark: tooFine(legibility(texture, mesh, { repeat })) };
  latest.set(texture, now);
  return now;
}
