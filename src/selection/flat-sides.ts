import { doubledAreaVector, length, row } from '../mesh/vectors.ts';
import { faceNormals } from './face-normals.ts';
import { facesOfPatch } from './face-sets.ts';
import { smooth } from './features.ts';
import type { SelectableMesh } from './selectable.ts';
import { faceCount, faceOfSide, none, sideAcross } from './topology.ts';
import { atOnce } from './work.ts';

/** What looks another way by less than this is flat, as a cosine: 1°. */
const flat = Math.cos(Math.PI / 180);

/** A flat side has so many times the area of any flat strip that leads around its edges, else it is one of a bend's own. */
const leastRatio = 4;

/** And this share of the smooth patch that it lies in: less is no side of the shape. */
const leastShare = 0.02;

/** What is known of a surface: its faces by the planes that they lie in, found where somebody points. */
interface Flats {
  readonly normals: Float32Array;
  /** #S, the number of a face's region, or `none`. */
  readonly of: Uint32Array;
  /** #S, faces region by region; those of region k from `start[k]` to `start[k + 1]`. */
  readonly members: Uint32Array;
  readonly start: number[];
  /** Of each region, twice its area. */
  readonly areas: number[];
  /** Of each region that was asked for. */
  readonly areSides: Map<number, boolean>;
  /** Twice the areas of patches, by their numbers. */
  readonly patchAreas: Map<number, number>;
}

const known = new WeakMap<SelectableMesh, Flats>();

/**
 * The faces of the flat side that a face lies in, a view, where a shape has rounded edges: there the smooth patch goes on around
 * them, which nobody means who points at a side. Null where a face lies in no such side: on a bend, on a figure, on a plane that is
 * a patch by itself.
 */
export function flatSideOf(surface: SelectableMesh, face: number): Uint32Array | null {
  const flats = known.get(surface) ?? begin(surface);
  const region = regionOf(surface, flats, face);
  const isOne = flats.areSides.get(region) ?? isSide(surface, flats, region);
  flats.areSides.set(region, isOne);
  return isOne ? facesOf(flats, region) : null;
}

function begin(surface: SelectableMesh): Flats {
  const faces = faceCount(surface.topology);
  const flats = {
    normals: atOnce(faceNormals(surface.topology, surface.places)),
    of: new Uint32Array(faces).fill(none),
    members: new Uint32Array(faces),
    start: [0],
    areas: [] as number[],
    areSides: new Map<number, boolean>(),
    patchAreas: new Map<number, number>(),
  };
  known.set(surface, flats);
  return flats;
}

const facesOf = ({ members, start }: Flats, region: number): Uint32Array =>
  members.subarray(start[region]!, start[region + 1]!);

function regionOf(surface: SelectableMesh, flats: Flats, face: number): number {
  const { normals, of, members, start, areas } = flats;
  if (of[face] !== none) return of[face]!;
  const region = areas.length;
  const from = start[region]!;
  let end = from;
  const take = (one: number) => {
    of[one] = region;
    members[end++] = one;
  };
  take(face);
  for (let k = from; k < end; k++)
    for (let side = 3 * members[k]!; side < 3 * members[k]! + 3; side++) {
      const other = smoothlyAcross(surface, side);
      if (other !== none && of[other] === none && cosine(normals, face, other) >= flat) take(other);
    }
  start.push(end);
  areas.push(areaOf(surface, members.subarray(from, end)));
  return region;
}

function isSide(surface: SelectableMesh, flats: Flats, region: number): boolean {
  const faces = facesOf(flats, region);
  const area = flats.areas[region]!;
  const patch = facesOfPatch(surface, faces[0]!);
  if (faces.length === patch.length || area < leastShare * patchArea(surface, flats, patch)) return false;
  for (const face of faces)
    for (let side = 3 * face; side < 3 * face + 3; side++) {
      const other = smoothlyAcross(surface, side);
      if (other === none || flats.of[other] === region) continue;
      if (leastRatio * flats.areas[regionOf(surface, flats, other)]! > area) return false;
    }
  return true;
}

/** The face across a side where the surface is smooth there, else `none`. */
function smoothlyAcross({ topology, features }: SelectableMesh, side: number): number {
  const edge = topology.edgeOfSide[side]!;
  if (edge === none || features[edge] !== smooth) return none;
  const across = sideAcross(topology, side);
  return across === none ? none : faceOfSide(across);
}

/** Twice the area of a patch, summed once. */
function patchArea(surface: SelectableMesh, { patchAreas }: Flats, patch: Uint32Array): number {
  const number = surface.patches.of[patch[0]!]!;
  const area = patchAreas.get(number) ?? areaOf(surface, patch);
  patchAreas.set(number, area);
  return area;
}

function cosine(normals: Float32Array, a: number, b: number): number {
  return (
    normals[3 * a]! * normals[3 * b]! +
    normals[3 * a + 1]! * normals[3 * b + 1]! +
    normals[3 * a + 2]! * normals[3 * b + 2]!
  );
}

/** Twice the area of some faces. */
function areaOf({ topology, places }: SelectableMesh, faces: ArrayLike<number>): number {
  let sum = 0;
  for (let k = 0; k < faces.length; k++) {
    const at = (corner: number) => row(places, topology.triangles[3 * faces[k]! + corner]!);
    sum += length(doubledAreaVector(at(0), at(1), at(2)));
  }
  return sum;
}
