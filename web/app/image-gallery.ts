import type { Source } from '../../src/editor/project.ts';
import type { Image } from '../../src/inputs/images/image.ts';
import { findPattern, patternIds } from '../../src/inputs/images/patterns.ts';
import { rememberedTexture } from '../../src/inputs/images/read.ts';
import type { Texture, TextureOptions } from '../../src/inputs/images/texture.ts';
import type { Asset } from '../../src/recipe/index.ts';

/** An image that can be laid on a mesh. Immutable. */
export interface ImageEntry {
  /** Unique on the page. */
  readonly id: string;
  readonly name: string;
  /** As recipes and the command line call it; absent for the normal map inside the mesh's own file, which needs no name. */
  readonly source?: string;
  /** What the person brought; it can be read in more than one way. */
  readonly image?: Image;
  /** That image as the resolver takes it; absent for the normal map inside the mesh's own file. */
  readonly asset?: ImageAsset;
  /** The file that has it inside; other meshes do not get it. */
  readonly file?: Source;
  /** Makes the texture, the same object for the same options. @throws WhittleError as `textureOf` */
  readonly texture: (options?: TextureOptions) => Texture;
}

/** The patterns that come with the page. */
export const builtInImages: readonly ImageEntry[] = patternIds.map((id) => ({
  id: `pattern-${id}`,
  name: id.charAt(0).toUpperCase() + id.slice(1),
  source: id,
  texture: () => findPattern(id)!,
}));

let brought = 0;

/** An image that was read from a file. */
export type ImageAsset = Extract<Asset, { kind: 'image' }>;

/** An image of the person's own. @param source its name in recipes, unlike all others */
export function ownImage(source: string, asset: ImageAsset): ImageEntry {
  return { ...imageOf(source, asset.image), source, asset };
}

/** The normal map inside a mesh file. */
export function embeddedImage(name: string, image: Image, file: Source): ImageEntry {
  return { ...imageOf(name, image), file };
}

function imageOf(file: string, image: Image): ImageEntry {
  const texture = (options?: TextureOptions) => rememberedTexture(image, file, options);
  return { id: `own-image-${++brought}`, name: file.replace(/\.[^.]*$/, '') || file, image, texture };
}
