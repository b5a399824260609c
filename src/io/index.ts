import type { Mesh } from '../mesh/mesh.ts';
import { gather, joinPlaces, weld } from '../mesh/weld.ts';
import { plainBytes } from './bytes.ts';
import { fitsFloat32, unfitPosition } from './fit.ts';
import { type Format, formats, isFormat } from './formats.ts';
import { handlers } from './handlers.ts';
import { type EmbeddedImage, type ParsedFile, type Shape, triangleFaces } from './parsed-file.ts';
import { withPlaceless } from './placeless.ts';
import { triangulate } from './polygon.ts';
import { counted, refusal } from './refuse.ts';
import { recognise } from './sniff.ts';

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
 * @throws WhittleError empty-file, unknown-format, truncated-file, malformed-file, unsupported-file, no-faces,
 *   index-out-of-range, not-finite or too-large; never anything else
 */
export function readMesh(bytes: Uint8Array, name: string): ReadMesh {
  const { format, file } = parse(bytes, name);
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
 * Gives a file back with other positions.
 *
 * In the source's own format only positions and normals change, and of these only those that are not what they were;
 * the same positions give the same bytes. Another format gets a new file: positions, faces, colours if it has them.
 * Binary STL, `float` PLY and glTF hold 32-bit numbers, so positions are rounded there; text formats are exact.
 *
 * @param positions #P×3 in the order of `readMesh`
 * @throws WhittleError as `readMesh`; bad-parameter if the number of positions is another; not-finite if one is not
 *   finite, or not in 32 bits where the format has 32; unsupported-file if the source cannot hold the new shape
 */
export function writeMesh(
  source: Uint8Array,
  name: string,
  format: Format,
  positions: Float64Array,
): Uint8Array<ArrayBuffer> {
  if (!isFormat(format)) {
    throw refusal(
      'unknown-format',
      name,
      '',
      `"${format}" is not one of ${formats.map(({ id }) => id).join(', ')}.`,
    );
  }
  const bytes = plainBytes(source);
  const parsed = parse(bytes, name);
  checkPositions(parsed.file, format, name, positions);
  const after = withPlaceless(parsed.file, positions);
  if (parsed.format === format) return parsed.patch(after);
  return handlers[format].write(shapeOf(parsed.file, parsed.format, after));
}

interface Parsed {
  readonly format: Format;
  readonly file: ParsedFile;
  patch(positions: Float64Array): Uint8Array<ArrayBuffer>;
}

function parse(source: Uint8Array, name: string): Parsed {
  const bytes = plainBytes(source);
  if (bytes.length > mostBytes) {
    throw refusal('too-large', name, '', 'files above 2 GB are not read; split the model.');
  }
  const format = recognise(bytes, name);
  return { format, ...handlers[format].read(bytes, name) };
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
function shapeOf(file: ParsedFile, format: Format, positions: Float64Array): Shape {
  const { triangles } = triangulate(file.positions, file.faces);
  if (format === 'stl-binary' || format === 'stl-ascii') {
    const joined = joinPlaces(file.positions, triangles);
    const faces = triangleFaces(joined.triangles);
    return { positions: gather(positions, joined), faces, triangles: joined.triangles };
  }
  const { faces, colors } = file;
  return { positions, faces, triangles, ...(colors ? { colors } : {}) };
}
