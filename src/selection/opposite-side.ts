import { add, dot, doubledAreaVector, length, row, scale, unit, type Vec3 } from '../mesh/vectors.ts';
import { facesOfPart, facesOfPatch, verticesOfFaces } from './face-sets.ts';
import { flatSideOf } from './flat-sides.ts';
import type { SelectableMesh } from './selectable.ts';

/** Patches smaller than this, by the area of their part, are no sides. */
const leastShare = 0.01;

/** A side looks the other way if the cosine between the two is below this. */
const awayCosine = -0.5;

/** Where some faces look on the whole, unit; zero where they look everywhere, as those of a ball do. */
export function outlookOf(surface: SelectableMesh, faces: Uint32Array): Vec3 {
  const { sum, area } = spanOf(surface, faces);
  return length(sum) > flatShare * area ? unit(sum) : [0, 0, 0];
}

/** Of the area of a patch, how much its faces have to agree on for it to look anywhere. */
const flatShare = 0.5;

/**
 * The side of a part that has to stay where it is for another to be pulled away from it: of those that look the other way the
 * farthest, or else the farthest of all. Null where the pulled one looks nowhere, or there is no other. Sides are flat ones between
 * rounded edges and, where a surface has none of these, smooth patches.
 *
 * @param faces the pulled side
 * @returns welded vertices, none of them of the pulled side
 */
export function oppositeSide(surface: SelectableMesh, faces: Uint32Array): Uint32Array | null {
  const way = outlookOf(surface, faces);
  if (faces.length === 0 || length(way) === 0) return null;
  const whole = spanOf(surface, facesOfPart(surface, faces[0]!)).area;
  let best: { side: Uint32Array; isAway: boolean; height: number } | null = null;
  for (const side of otherSides(surface, faces)) {
    const { area, sum, center } = spanOf(surface, side);
    if (area < leastShare * whole) continue;
    const isAway = dot(unit(sum), way) < awayCosine;
    const height = dot(center, way);
    const isBetter = !best || (isAway === best.isAway ? height < best.height : isAway);
    if (isBetter) best = { side, isAway, height };
  }
  if (!best) return null;
  const taken = new Set(verticesOfFaces(surface, faces));
  return verticesOfFaces(surface, best.side).filter((vertex) => !taken.has(vertex));
}

/** The sides of the part of some faces, but for the one that these are. */
function otherSides(surface: SelectableMesh, faces: Uint32Array): Uint32Array[] {
  const { patches } = surface;
  const sides: Uint32Array[] = [];
  const seen = new Set(faces);
  const done = new Set([patches.of[faces[0]!]!]);
  const part = facesOfPart(surface, faces[0]!);
  for (const face of part) {
    const side = seen.has(face) ? null : flatSideOf(surface, face);
    if (!side) continue;
    for (const one of side) seen.add(one);
    done.add(patches.of[face]!);
    sides.push(side);
  }
  for (const face of part) {
    if (done.has(patches.of[face]!)) continue;
    done.add(patches.of[face]!);
    sides.push(facesOfPatch(surface, face));
  }
  return sides;
}

/** Doubled areas of faces: all of them, as vectors, and their middle. */
function spanOf({ topology, places }: SelectableMesh, faces: Uint32Array) {
  let sum: Vec3 = [0, 0, 0];
  let middle: Vec3 = [0, 0, 0];
  let area = 0;
  for (const face of faces) {
    const [a, b, c] = [0, 1, 2].map((k) => row(places, topology.triangles[3 * face + k]!)) as [
      Vec3,
      Vec3,
      Vec3,
    ];
    const vector = doubledAreaVector(a, b, c);
    const size = length(vector);
    sum = add(sum, vector);
    middle = add(middle, scale(add(add(a, b), c), size / 3));
    area += size;
  }
  return { sum, area, center: scale(middle, 1 / (area || 1)) };
}
