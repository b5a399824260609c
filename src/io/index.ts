import type { Mesh } from '../mesh/mesh.ts';
import { gather, joinPlaces, weld } from '../mesh/weld.ts';
import { type FilesBeside, nothingBeside, type Reference } from './beside.ts';
import { plainBytes } from './bytes.ts';
import { fitsFloat32, unfitPosition } from './fit.ts';
import { type Format, formatInfo, formats, isFormat } from './formats.ts';
import { handlers, type Parsed } from './handlers.ts';
import { losses } from './look/losses.ts';
import { type EmbeddedImage, type ParsedFile, type Shape, triangleFaces } from './parsed-file.ts';
import { withPlaceless } from './placeless.ts';
import { triangulate } from './polygon.ts';
import { counted, refusal } from './refuse.ts';
import { recognise } from './sniff.ts';

export { type FilesBeside, nameOfPath, type Reference } from './beside.ts';
export {
  type Compression,
  type Decoders,
  type DracoAttributes,
  type DracoMesh,
  type PlainFile,
  uncompressed,
} from './compressed.ts';
export {
  endingOf,
  type Format,
  type FormatInfo,
  fileNameEndings,
  formatForFileName,
  formatInfo,
  formats,
  isFormat,
  isMeshFileName,
} from './formats.ts';
export type { EmbeddedImage } from './parsed-file.ts';
export {
  fitsInProject,
  isProjectFile,
  type ProjectFile,
  packProject,
  unpackProject,
} from './project-file.ts';

export interface ReadMesh {
  readonly mesh: Mesh;
  readonly format: Format;
  /** The normal map that the file has inside, if all its parts share one. */
  readonly normalMap?: EmbeddedImage;
  /** Sentences about what was skipped or simplified. */
  readonly warnings: string[];
}

/** Larger files are refused: byte offsets and lengths must fit into 31 bits. */
const mostBytes = 2 ** 31 - 1;

/**
 * Understands a mesh file, by its bytes alone.
 *
 * @param name for messages only
 * @param beside files that it refers to
 * @throws WhittleError empty-file, unknown-format, truncated-file, malformed-file, unsupported-file, no-faces,
 *   index-out-of-range, not-finite or too-large; never anything else
 */
export function readMesh(bytes: Uint8Array, name: string, beside: FilesBeside = nothingBeside): ReadMesh {
  const { format, file } = parse(bytes, name, beside);
  const { positions, colors, normalMap } = file;
  const { triangles, corners, roughFaces } = triangulate(positions, file.faces);
  const uvs = file.uvs && cornerUvs(file.uvs, corners);
  const warnings = [...file.warnings];
  if (roughFaces > 0) warnings.push(`Split ${counted(roughFaces, 'very large polygon')} roughly.`);
  const mesh = {
    positions,
    triangles,
    weld: weld(positions, triangles),
    ...(colors ? { colors } : {}),
    ...(uvs ? { uvs } : {}),
  };
  return { mesh, format, warnings, ...(normalMap ? { normalMap } : {}) };
}

/**
 * The files beside a mesh file that it refers to: buffers and images of glTF, materials and textures of OBJ. A material that is not
 * there cannot say which textures it has: ask again when it is.
 *
 * @param beside those that are there already
 * @throws WhittleError as `readMesh` where the file is not even to be recognised
 */
export function referencesOf(
  bytes: Uint8Array,
  name: string,
  beside: FilesBeside = nothingBeside,
): readonly Reference[] {
  const plain = plainBytes(bytes);
  return handlers[recognise(plain, name)].references?.(plain, name, beside) ?? [];
}

/** A mesh file that was written. */
export interface WrittenMesh {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Sentences about what the source has and the new file lacks. */
  readonly warnings: readonly string[];
}

/**
 * Gives a file back with other positions.
 *
 * In the source's own format only positions and normals change, and of these only those that are not what they were;
 * the same positions give the same bytes. glTF as GLB, and the other way round, is the same asset in one file. Any other format
 * gets a new file: positions and faces, and what the format has room for of colours, texture coordinates, materials with their
 * textures, and names of parts.
 * Binary STL, `float` PLY and glTF hold 32-bit numbers, so positions are rounded there; text formats are exact.
 *
 * @param positions #P×3 in the order of `readMesh`
 * @param beside files that the source refers to
 * @throws WhittleError as `readMesh`; bad-parameter if the number of positions is another; not-finite if one is not
 *   finite, or not in 32 bits where the format has 32; unsupported-file if the source cannot hold the new shape
 */
export function writeMesh(
  source: Uint8Array,
  name: string,
  format: Format,
  positions: Float64Array,
  beside: FilesBeside = nothingBeside,
): WrittenMesh {
  if (!isFormat(format)) {
    throw refusal(
      'unknown-format',
      name,
      '',
      `"${format}" is not one of ${formats.map(({ id }) => id).join(', ')}.`,
    );
  }
  const parsed = parse(source, name, beside);
  checkPositions(parsed.file, format, name, positions);
  const after = withPlaceless(parsed.file, positions);
  if (parsed.format === format) return { bytes: parsed.patch(after), warnings: [] };
  const repack = handlers[parsed.format].repack?.[format];
  if (repack) return { bytes: repack(parsed.patch(after), name, beside), warnings: [] };
  const shape = shapeOf(parsed, after);
  const { write, room } = handlers[format];
  return { bytes: write(shape), warnings: losses(shape, room, formatInfo(format).label) };
}

function parse(source: Uint8Array, name: string, beside: FilesBeside): Parsed & { readonly format: Format } {
  const bytes = plainBytes(source);
  if (bytes.length > mostBytes) {
    throw refusal('too-large', name, '', 'files above 2 GB are not read; split the model.');
  }
  const format = recognise(bytes, name);
  return { format, ...handlers[format].read(bytes, name, beside) };
}

function checkPositions(file: ParsedFile, format: Format, name: string, positions: Float64Array): void {
  if (positions.length !== file.positions.length) {
    const wanted = counted(file.positions.length / 3, 'position');
    const sentence = `it has ${wanted}, but ${positions.length / 3} were given; read it again.`;
    throw refusal('bad-parameter', name, '', sentence);
  }
  // A PLY may hold doubles and a glTF may scale, so these two look again when they patch.
  const is32Bit = format === 'stl-binary' || format === 'glb' || format === 'gltf';
  for (let i = 0; i < positions.length; i++) {
    const value = positions[i];
    const isNew = value !== file.positions[i];
    if (isNew && !(is32Bit ? fitsFloat32(value) : Number.isFinite(value))) {
      throw unfitPosition(name, Math.floor(i / 3), value);
    }
  }
}

/** Texture coordinates of the triangles' corners: each is one of a polygon's. */
function cornerUvs(
  uvs: Float32Array<ArrayBuffer>,
  corners: Uint32Array | undefined,
): Float32Array<ArrayBuffer> {
  if (!corners) return uvs;
  const result = new Float32Array(2 * corners.length);
  for (let c = 0; c < corners.length; c++) {
    result[2 * c] = uvs[2 * corners[c]];
    result[2 * c + 1] = uvs[2 * corners[c] + 1];
  }
  return result;
}

/** The shape for a new file. Corners of an STL are joined where the file has them in the same place. */
function shapeOf(
  { file, format, look }: Parsed & { readonly format: Format },
  positions: Float64Array,
): Shape {
  const { triangles, corners } = triangulate(file.positions, file.faces);
  const triangleCorners = corners ?? Uint32Array.from({ length: triangles.length }, (_, c) => c);
  if (format === 'stl-binary' || format === 'stl-ascii') {
    const joined = joinPlaces(file.positions, triangles);
    const faces = triangleFaces(joined.triangles);
    const gathered = gather(positions, joined);
    return { positions: gathered, faces, triangles: joined.triangles, triangleCorners, look: look() };
  }
  const { faces, colors, uvs } = file;
  return {
    ...{ positions, faces, triangles, triangleCorners, look: look() },
    ...(colors ? { colors } : {}),
    ...(uvs ? { uvs } : {}),
  };
}
