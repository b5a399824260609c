import { row } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import type { TestMesh } from '../fixtures/subdivision.ts';

/** A mesh with its vertices and faces in another order. */
export interface Shuffled {
  readonly mesh: TestMesh;
  /** Handles of the mesh as it was, for the vertices as they are now. */
  handles(of: Handles): Handles;
  /** Positions in the order that the mesh had before. */
  back(positions: Float64Array): Float64Array<ArrayBuffer>;
}

/** Vertices take steps through the mesh, faces are read from the last to the first, each from its second corner on. */
export function shuffled({ positions, triangles }: TestMesh): Shuffled {
  const count = positions.length / 3;
  const step = [101, 103, 107].find((prime) => count % prime !== 0)!;
  const placeOf = (v: number): number => (step * v + 3) % count;
  const moved = new Float64Array(positions.length);
  for (let v = 0; v < count; v++) moved.set(row(positions, v), 3 * placeOf(v));
  const faces = Array.from({ length: triangles.length / 3 }, (_, t) => triangles.subarray(3 * t, 3 * t + 3));
  return {
    mesh: {
      positions: moved,
      triangles: Uint32Array.from(faces.toReversed().flatMap(([a, b, c]) => [b!, c!, a!].map(placeOf))),
    },
    handles: ({ vertices, targets }) => ({ vertices: vertices.map(placeOf), targets }),
    back(of) {
      const there = new Float64Array(of.length);
      for (let v = 0; v < count; v++) there.set(row(of, placeOf(v)), 3 * v);
      return there;
    },
  };
}
