import { faceNormals } from './face-normals.ts';
import { type Labels, labelled } from './labels.ts';
import { edgeCount, faceCount, faceOfSide, none, sideAcross, sidesOf, type Topology } from './topology.ts';
import { pieceLength, type Work } from './work.ts';

/**
 * Degrees by which a surface bends at a feature edge, at least. Edges of boxes and rims of cylinders bend by 90°, sides of a
 * cylinder of twelve by 30°; scans and sculptures of a few thousand faces have next to nothing above 40°.
 */
export const defaultFeatureAngle = 40;

/** How an edge takes part in the lines of a shape. */
export const smooth = 0;
/** The surface bends by more than the angle, or more than two faces meet. */
export const crease = 1;
/** The surface ends. */
export const border = 2;

/**
 * The kind of each edge, #E: {@link smooth}, {@link crease} or {@link border}.
 *
 * @param positions #V×3
 */
export function* featuresOf(
  topology: Topology,
  positions: Float64Array,
  angle = defaultFeatureAngle,
): Work<Uint8Array> {
  const normals = yield* faceNormals(topology, positions);
  const edges = edgeCount(topology);
  const kind = new Uint8Array(edges);
  const least = Math.cos((angle * Math.PI) / 180);
  for (let edge = 0; edge < edges; edge++) {
    kind[edge] = kindOf(topology, normals, edge, least);
    if (edge % pieceLength === 0) yield;
  }
  return kind;
}

function kindOf(topology: Topology, normals: Float32Array, edge: number, least: number): number {
  const count = sidesOf(topology, edge);
  if (count !== 2) return count === 1 ? border : crease;
  const first = topology.sideStart[edge]!;
  const a = 3 * faceOfSide(topology.sides[first]!);
  const b = 3 * faceOfSide(topology.sides[first + 1]!);
  const cosine =
    normals[a]! * normals[b]! + normals[a + 1]! * normals[b + 1]! + normals[a + 2]! * normals[b + 2]!;
  return cosine < least ? crease : smooth;
}

/** The edges that are not smooth, #×2 welded vertices. */
export function sharpEdges({
  topology,
  features,
}: {
  topology: Topology;
  features: Uint8Array;
}): Uint32Array {
  const found: number[] = [];
  for (let edge = 0; edge < features.length; edge++)
    if (features[edge] !== smooth) found.push(topology.ends[2 * edge]!, topology.ends[2 * edge + 1]!);
  return Uint32Array.from(found);
}

/** The smooth patches of a mesh: its faces, flooded up to feature edges. */
export function* patchesOf(topology: Topology, features: Uint8Array): Work<Labels> {
  const faces = faceCount(topology);
  const patchOf = new Uint32Array(faces).fill(none);
  const waiting = new Uint32Array(faces);
  let count = 0;
  let done = 0;
  for (let seed = 0; seed < faces; seed++) {
    if (patchOf[seed] !== none) continue;
    const patch = count++;
    patchOf[seed] = patch;
    waiting[0] = seed;
    for (let size = 1; size > 0; ) {
      const face = waiting[--size]!;
      for (let side = 3 * face; side < 3 * face + 3; side++) {
        const across = sideAcross(topology, side);
        if (across === none || features[topology.edgeOfSide[side]!] !== smooth) continue;
        const other = faceOfSide(across);
        if (patchOf[other] !== none) continue;
        patchOf[other] = patch;
        waiting[size++] = other;
      }
      if (++done % pieceLength === 0) yield;
    }
  }
  yield;
  return labelled(patchOf, count);
}
