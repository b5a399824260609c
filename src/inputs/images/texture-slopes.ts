import { WhittleError } from '../../mesh/failure.ts';
import type { Mesh } from '../../mesh/mesh.ts';
import { length, row } from '../../mesh/vectors.ts';
import type { TextureSlopes } from '../../methods/values/texture-slopes.ts';
import { areaVectors } from '../styles/surface.ts';
import { Pyramid } from './pyramid.ts';
import type { Texture } from './texture.ts';

export interface TextureSlopesOptions {
  /** How often the image is laid side by side over texture coordinates from 0 to 1. Default 1. */
  readonly repeat?: number | undefined;
}

/** Pyramids of textures that were seen already. */
const pyramids = new WeakMap<Texture, Pyramid>();

function pyramidOf(texture: Texture): Pyramid {
  const pyramid = pyramids.get(texture) ?? new Pyramid(texture);
  pyramids.set(texture, pyramid);
  return pyramid;
}

/**
 * Lays a texture on a mesh, by the mesh's texture coordinates: what the parameter `image` of `normalmap` takes in the engine. Each
 * corner gets the mean over what its vertex covers of the image, so that a coarse mesh sees no noise between its vertices.
 *
 * @throws WhittleError `unsuitable-mesh` if the mesh has no texture coordinates
 */
export function textureSlopesOf(
  texture: Texture,
  mesh: Pick<Mesh, 'uvs'>,
  { repeat = 1 }: TextureSlopesOptions = {},
): TextureSlopes {
  const uvs = requireUvs(mesh);
  const pyramid = pyramidOf(texture);
  const slopes = new Float32Array(uvs.length);
  const mean = new Float64Array(2);
  for (let face = 0; face < uvs.length; face += 6) {
    // Reading between pixels widens the footprint again, by about half a level.
    const level = Math.log2(footprint(texture, uvs, face, repeat)) - 0.5;
    for (let at = face; at < face + 6; at += 2) {
      const [u, v] = [uvs[at]! * repeat, uvs[at + 1]! * repeat];
      if (!Number.isFinite(u + v)) continue;
      pyramid.sample(u, v, level, mean);
      slopes.set(mean, at);
    }
  }
  return { uvs, slopes };
}

/** How much of a texture a mesh is fine enough to show. */
export interface Legibility {
  /** Pixels of the image along an edge, typically. */
  readonly pixelsPerEdge: number;
  /** What is left of its slopes when it is averaged over so many pixels, from 0 to 1. */
  readonly kept: number;
}

/** @throws WhittleError as {@link textureSlopesOf} */
export function legibility(
  texture: Texture,
  mesh: Pick<Mesh, 'uvs'>,
  { repeat = 1 }: TextureSlopesOptions = {},
): Legibility {
  const uvs = requireUvs(mesh);
  const sizes = new Float64Array(uvs.length / 6).map((_, f) => footprint(texture, uvs, 6 * f, repeat));
  const typical = sizes.sort()[sizes.length >> 1]!;
  const pyramid = pyramidOf(texture);
  const all = pyramid.steepness(0);
  return { pixelsPerEdge: typical, kept: all === 0 ? 1 : pyramid.steepness(Math.log2(typical)) / all };
}

/** A sentence for an image that is too fine for the mesh; undefined if enough of it is to be seen. */
export function tooFine({ pixelsPerEdge, kept }: Legibility): string | undefined {
  if (kept >= 0.35) return undefined;
  const pixels = Math.max(2, Math.round(pixelsPerEdge));
  return `The image is finer than this mesh can show: an edge spans about ${pixels} of its pixels, and ${Math.round(100 * kept)} % of the relief is left. Repeat it less, or subdivide the mesh.`;
}

/**
 * How often an image that comes once lies along the mesh: the side of the whole texture, as an area, over that of the surface, times
 * the mesh's diagonal.
 *
 * @throws WhittleError as {@link textureSlopesOf}
 */
export function tilesAlong(mesh: Pick<Mesh, 'positions' | 'triangles' | 'uvs'>): number {
  const uvs = requireUvs(mesh);
  let [inTexture, onSurface] = [0, 0];
  const vectors = areaVectors(mesh);
  for (let face = 0; 3 * face < vectors.length; face++) {
    inTexture += Math.abs(doubledArea(uvs, 6 * face)) || 0;
    onSurface += length(row(vectors, face));
  }
  return diagonal(mesh.positions) * Math.sqrt(inTexture / onSurface);
}

function diagonal(positions: Float64Array): number {
  const [low, high] = [new Float64Array(3).fill(Infinity), new Float64Array(3).fill(-Infinity)];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3]!, x);
    high[i % 3] = Math.max(high[i % 3]!, x);
  });
  return Math.hypot(...high.map((x, axis) => x - low[axis]!));
}

function requireUvs({ uvs }: Pick<Mesh, 'uvs'>): Float32Array {
  if (uvs) return uvs;
  throw new WhittleError(
    'unsuitable-mesh',
    'The mesh has no texture coordinates, and normalmap needs them to lay the image on it; unwrap it and export it with UVs.',
  );
}

/**
 * Side of the square that a vertex of such a face covers, in pixels, at least 1. Of the six faces around a vertex a third each is
 * its own: twice a face.
 */
function footprint({ width, height }: Texture, uvs: Float32Array, face: number, repeat: number): number {
  const pixels = Math.abs(doubledArea(uvs, face)) * repeat * repeat * width * height;
  return Math.max(1, Math.sqrt(pixels)) || 1;
}

/** Twice the area of a face in the texture, NaN where coordinates are missing; `face` is where its six numbers begin. */
function doubledArea(uvs: Float32Array, face: number): number {
  const along = (k: number): number => uvs[face + k]! - uvs[face + (k & 1)]!;
  return along(2) * along(5) - along(4) * along(3);
}
