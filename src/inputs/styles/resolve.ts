import { WhittleError } from '../../mesh/failure.ts';
import type { Mesh } from '../../mesh/mesh.ts';
import { length, unit } from '../../mesh/vectors.ts';
import { didYouMean } from '../../methods/suggest.ts';
import type { GaussMap } from '../../methods/values/gauss-map.ts';
import type { Directions } from '../../methods/values/points.ts';
import { captureIds, findCapture } from './capture-gallery.ts';
import { normalsOfConvex } from './convex-normals.ts';
import { isFaceted } from './faceted.ts';
import { findPrimitive, primitiveIds } from './primitives.ts';
import { refined } from './refined.ts';
import { sphereNormals } from './sphere-normals.ts';
import { findStyleMesh, styleMeshIds } from './style-meshes.ts';
import type { Surface } from './surface.ts';

/** How a style is read; `auto` takes the closest normal of what is convex and has few of them, the sphere for all else. */
export type Mapping = 'auto' | 'closest' | 'spherical';

/** The name of a primitive, of a style mesh or of a capture, a closed surface, or the directions themselves. */
export type StyleSource = string | Surface | Directions;

/**
 * Lets a mesh flow to a sphere: the method `spherical`, run to its end.
 *
 * @returns #P×3, in the order of the mesh's positions
 */
export type Flow = (mesh: Mesh) => Promise<Float64Array>;

/** All names that {@link resolveStyle} knows, in the order of a gallery. */
export const styleNames: readonly string[] = [...primitiveIds, ...styleMeshIds, ...captureIds];

/**
 * Makes of a style what a style parameter takes in the engine (`style` of an analogy, `directions` of a polycube).
 *
 * @throws WhittleError `bad-parameter` for a name that is none, for a capture where faces are asked for and for what is no direction,
 *   `unsuitable-mesh` for a surface that the mapping cannot read: not
 *   convex for `closest`; open, in parts, with handles or too uneven for `spherical`
 */
export async function resolveStyle(source: StyleSource, mapping: Mapping, flow: Flow): Promise<GaussMap> {
  if (isDirections(source)) return { kind: 'closest', normals: unitNormals(source) };
  if (typeof source !== 'string') return ofSurface(source, mapping, flow);
  const primitive = findPrimitive(source);
  if (primitive) {
    if (mapping === 'spherical') return onSphere(primitive.mesh, flow);
    return { kind: 'closest', normals: primitive.normals };
  }
  const style = findStyleMesh(source);
  if (style) return ofSurface(style.mesh, mapping === 'auto' ? 'spherical' : mapping, flow);
  const capture = findCapture(source);
  if (capture && mapping === 'closest') {
    throw new WhittleError(
      'bad-parameter',
      `“${source}” is a normal capture and has no faces; choose a convex shape.`,
    );
  }
  if (capture) return capture.map;
  throw new WhittleError(
    'bad-parameter',
    `There is no style “${source}”.${didYouMean(source, styleNames)} A mesh file is named with its ending.`,
  );
}

function isDirections(source: StyleSource): source is Directions {
  return Array.isArray(source);
}

function unitNormals(directions: Directions): Float64Array {
  if (directions.length === 0)
    throw new WhittleError('bad-parameter', 'A style needs one direction or more.');
  const normals = directions.map(unit);
  const bad = normals.findIndex((normal) => !(length(normal) > 0.5));
  if (bad >= 0) {
    throw new WhittleError(
      'bad-parameter',
      `Direction ${bad} is [${directions[bad]!.join(', ')}]; a direction has three finite numbers, not all of them zero.`,
      bad,
    );
  }
  return Float64Array.from(normals.flat());
}

async function ofSurface(surface: Surface, mapping: Mapping, flow: Flow): Promise<GaussMap> {
  if (mapping === 'spherical') return onSphere(surface, flow);
  try {
    return { kind: 'closest', normals: normalsOfConvex(surface) };
  } catch (thrown) {
    const isUnsuitable = thrown instanceof WhittleError && thrown.code === 'unsuitable-mesh';
    if (mapping === 'closest' || !isUnsuitable) throw thrown;
    return onSphere(surface, flow);
  }
}

/** Facets keep their one normal each; what is smooth is interpolated. */
async function onSphere(surface: Surface, flow: Flow): Promise<GaussMap> {
  const mesh = refined(surface);
  const per = isFaceted(mesh) ? 'face' : 'vertex';
  const { points, triangles, vertexNormals, faceNormals } = sphereNormals(mesh, await flow(mesh));
  const normals = per === 'face' ? faceNormals : vertexNormals;
  return { kind: 'sphere', points, triangles, normals, per };
}
