import type { Source } from '../../src/editor/project.ts';
import type { Image } from '../../src/inputs/images/image.ts';
import { findPattern, patternIds } from '../../src/inputs/images/patterns.ts';
import { type Texture, type TextureOptions, textureOf } from '../../src/inputs/images/texture.ts';
import {
  legibility,
  type TextureSlopesOptions,
  textureSlopesOf,
  tilesAlong,
  tooFine,
} from '../../src/inputs/images/texture-slopes.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { TextureSlopes } from '../../src/methods/values/texture-slopes.ts';

/** A picture to be laid on a mesh. Immutable. */
export interface Picture {
  /** Unique on the page. */
  readonly id: string;
  readonly name: string;
  /** As recipes and the command line call it. */
  readonly source: string;
  /** Brought by the person, and can be read in more than one way. */
  readonly isOwn: boolean;
  /** The file that has it inside; other meshes do not get it. */
  readonly file?: Source;
  /** The same object for the same options. @throws WhittleError as `textureOf` */
  readonly read: (options?: TextureOptions) => Texture;
}

/** The patterns that come with the page. */
export const builtInPictures: readonly Picture[] = patternIds.map((id) => ({
  id: `pattern-${id}`,
  name: id.charAt(0).toUpperCase() + id.slice(1),
  source: id,
  isOwn: false,
  read: () => findPattern(id)!,
}));

let brought = 0;

/**
 * A picture of the person's own.
 *
 * @param file what it is called
 * @param inside the mesh file that it comes from, if it comes from one
 */
export function ownPicture(file: string, image: Image, inside?: Source): Picture {
  const textures = new Map<string, Texture>();
  const read = ({ reading = 'auto', green = 'up' }: TextureOptions = {}): Texture => {
    const key = `${reading} ${green}`;
    const texture = textures.get(key) ?? textureOf(image, file, { reading, green });
    textures.set(key, texture);
    return texture;
  };
  const name = file.replace(/\.[^.]*$/, '') || file;
  const id = `own-picture-${++brought}`;
  return { id, name, source: file, isOwn: true, read, ...(inside ? { file: inside } : {}) };
}

/** So many of a pattern's tiles along the mesh look right. */
const usualTiles = 3;
const mostRepeats = 8;
/** Fewer where the mesh could not show them: so much of the relief must be left. */
const wellShown = 0.7;

/** How often a picture comes at first: a pattern as its look asks for; one of one's own was made for the mesh and comes once. */
export function startingRepeat({ isOwn, read }: Picture, mesh: Mesh): number {
  if (isOwn || !mesh.uvs) return 1;
  let repeat = Math.min(mostRepeats, Math.max(1, Math.round(usualTiles / tilesAlong(mesh))));
  while (repeat > 1 && legibility(read(), mesh, { repeat }).kept < wellShown) repeat--;
  return repeat;
}

interface Laid {
  readonly mesh: Mesh;
  readonly repeat: number | undefined;
  readonly relief: TextureSlopes;
  /** What there is to say of it. */
  readonly remark: string | undefined;
}

/** How each texture was last laid on a mesh: strength and all else change far more often. */
const latest = new WeakMap<Texture, Laid>();

/**
 * A picture on a mesh.
 *
 * @param parameters of the method: how the picture is read and how often it comes
 * @throws WhittleError as `textureOf` and `textureSlopesOf`
 */
export function laid({ read }: Picture, mesh: Mesh, parameters: ParameterValues): Laid {
  const { repeat, ...options } = parameters as TextureOptions & TextureSlopesOptions;
  const texture = read(options);
  const known = latest.get(texture);
  if (known?.mesh === mesh && known.repeat === repeat) return known;
  const relief = textureSlopesOf(texture, mesh, { repeat });
  const now = { mesh, repeat, relief, remark: tooFine(legibility(texture, mesh, { repeat })) };
  latest.set(texture, now);
  return now;
}
