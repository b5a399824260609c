import { smooth } from './features.ts';
import { membersOf } from './labels.ts';
import type { SelectableMesh } from './selectable.ts';
import { faceOfSide, nextSide, none, sideAcross } from './topology.ts';

/** The faces of the smooth patch that a face belongs to, a view. */
export function facesOfPatch({ patches }: SelectableMesh, face: number): Uint32Array {
  return membersOf(patches, patches.of[face]!);
}

/** The faces of the part that a face belongs to, a view. */
export function facesOfPart({ facesOfParts }: SelectableMesh, face: number): Uint32Array {
  return membersOf(facesOfParts, facesOfParts.of[face]!);
}

/** The corners of some faces, each once. */
export function verticesOfFaces({ topology, visits }: SelectableMesh, faces: Uint32Array): Uint32Array {
  const found = new Uint32Array(Math.min(3 * faces.length, topology.vertices));
  let count = 0;
  visits.begin();
  for (const face of faces) {
    for (let corner = 3 * face; corner < 3 * face + 3; corner++) {
      const v = topology.triangles[corner]!;
      if (visits.vertex(v)) found[count++] = v;
    }
  }
  return found.slice(0, count);
}

/** The edges around a patch, #×2 welded vertices: where it ends at another, at a border, or bends back to itself. */
export function outlineOf({ topology, features, patches }: SelectableMesh, patch: number): Uint32Array {
  const { triangles, edgeOfSide } = topology;
  const drawn: number[] = [];
  for (const face of membersOf(patches, patch)) {
    for (let corner = 0; corner < 3; corner++) {
      const side = 3 * face + corner;
      const edge = edgeOfSide[side]!;
      if (edge === none || features[edge] === smooth) continue;
      const across = sideAcross(topology, side);
      const isInside = across !== none && patches.of[faceOfSide(across)] === patch;
      // A crease inside a patch has two sides in it; it is drawn once.
      if (isInside && across < side) continue;
      drawn.push(triangles[side]!, triangles[3 * face + ((corner + 1) % 3)]!);
    }
  }
  return Uint32Array.from(drawn);
}

/** The edges between some faces and all others, #×2 welded vertices. */
export function outlineOfFaces({ topology, visits }: SelectableMesh, faces: Uint32Array): Uint32Array {
  const drawn: number[] = [];
  visits.begin();
  for (const face of faces) visits.face(face);
  for (const face of faces) {
    for (let side = 3 * face; side < 3 * face + 3; side++) {
      const across = sideAcross(topology, side);
      if (across !== none && visits.hasFace(faceOfSide(across))) continue;
      drawn.push(topology.triangles[side]!, topology.triangles[nextSide(side)]!);
    }
  }
  return Uint32Array.from(drawn);
}

/** The faces that have all their corners in a set of vertices. */
export function facesInside({ topology, visits }: SelectableMesh, vertices: Uint32Array): Uint32Array {
  const { triangles, aroundStart, edgesAround, sideStart, sides } = topology;
  const found: number[] = [];
  visits.begin();
  for (const v of vertices) visits.vertex(v);
  for (const v of vertices) {
    for (let i = aroundStart[v]!; i < aroundStart[v + 1]!; i++) {
      const edge = edgesAround[i]!;
      for (let k = sideStart[edge]!; k < sideStart[edge + 1]!; k++) {
        const face = faceOfSide(sides[k]!);
        if (!visits.face(face)) continue;
        if (
          visits.hasVertex(triangles[3 * face]!) &&
          visits.hasVertex(triangles[3 * face + 1]!) &&
          visits.hasVertex(triangles[3 * face + 2]!)
        )
          found.push(face);
      }
    }
  }
  return Uint32Array.from(found);
}
