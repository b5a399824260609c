import { WhittleError } from '../../mesh/failure.ts';
import { cornersOfSolved } from '../../mesh/solved-faces.ts';
import { noIndices, type Parameter, type ValueKind } from './parameter.ts';
import { show } from './show.ts';

/**
 * An image as the engine takes it: how the surface is to rise and fall at the corners of its faces. `textureSlopesOf` of
 * `src/inputs/images` makes it of a texture and a mesh.
 */
export interface TextureSlopes {
  /** #F×3×2, texture coordinates of the faces' corners, v upward; they say which way u and v go on the surface. */
  readonly uvs: Float32Array;
  /** #F×3×2, rise along u and along v, a number of 1 being 45°. */
  readonly slopes: Float32Array;
}

/** A pattern of ours ('weave') or the path of an image file. */
export type ImageName = string;

/**
 * An image that lies on the mesh by its texture coordinates. In a recipe or on the command line an {@link ImageName}, which
 * `src/inputs/images` turns into the {@link TextureSlopes} that the engine takes.
 */
export interface TextureSlopesParameter extends Parameter {
  readonly kind: 'textureSlopes';
}

export const textureSlopes: ValueKind<TextureSlopesParameter, ImageName | TextureSlopes> = {
  problem(_, value) {
    if (typeof value === 'string' && value !== '') return undefined;
    const { uvs, slopes } = (value ?? {}) as Partial<Record<string, unknown>>;
    if (uvs instanceof Float32Array && slopes instanceof Float32Array && uvs.length === slopes.length)
      return undefined;
    return `must name an image or a pattern, or be the slopes of a texture, not ${show(value)}.`;
  },
  encode({ name }, value, { solved }) {
    if (typeof value === 'string') {
      throw new WhittleError(
        'bad-parameter',
        `“${name}” is the name “${value}”, but the engine takes slopes; make them with textureSlopesOf first.`,
      );
    }
    const [uvs, slopes] = [value.uvs, value.slopes].map((ofCorners) =>
      solved && ofCorners.length === 6 * solved.solvedOf.length
        ? cornersOfSolved(ofCorners, solved, 2)
        : ofCorners,
    ) as [Float32Array, Float32Array];
    const numbers = new Float64Array(uvs.length + slopes.length);
    numbers.set(uvs);
    numbers.set(slopes, uvs.length);
    return { name: '', numbers, indices: noIndices };
  },
  help: () => ({ value: 'NAME|FILE.png', range: 'default the normal map inside the file, if there is one' }),
  takesNames: true,
  fromText: (text) => text,
};
