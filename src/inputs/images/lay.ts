import type { Mesh } from '../../mesh/mesh.ts';
import type { TextureSlopes } from '../../methods/values/texture-slopes.ts';
import type { Texture } from './texture.ts';
import { legibility, type TextureSlopesOptions, textureSlopesOf, tooFine } from './texture-slopes.ts';

/** A texture on a mesh. */
export interface LaidTexture {
  readonly slopes: TextureSlopes;
  /** A sentence where the mesh is too coarse for the image. */
  readonly remark: string | undefined;
}

interface Latest extends LaidTexture {
  readonly uvs: Mesh['uvs'];
  readonly repeat: number | undefined;
}

/** How each texture was last laid on a mesh: strength and all else change far more often. */
const latest = new WeakMap<Texture, Latest>();

/**
 * Lays a texture on a mesh by its texture coordinates, which steps do not change.
 *
 * @throws WhittleError as `textureSlopesOf`
 */
export function layTexture(
  texture: Texture,
  { uvs }: Pick<Mesh, 'uvs'>,
  { repeat }: TextureSlopesOptions,
): LaidTexture {
  const known = latest.get(texture);
  if (known && known.uvs === uvs && known.repeat === repeat) return known;
  const surface = uvs ? { uvs } : {};
  const slopes = textureSlopesOf(texture, surface, { repeat });
  const laid = { uvs, repeat, slopes, remark: tooFine(legibility(texture, surface, { repeat })) };
  latest.set(texture, laid);
  return laid;
}
