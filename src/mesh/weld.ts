import type { Mesh, Weld } from './mesh.ts';
import { joinNearPlaces } from './near-places.ts';
import { cornersOfSolved, solvedFacesOf } from './solved-faces.ts';
import { row, type Vec3 } from './vectors.ts';

const welds = new WeakMap<Pick<Mesh, 'positions' | 'triangles'>, Weld>();

/** The weld that a mesh carries; one that carries none gets one by its own positions, once. */
export function weldOf(mesh: Pick<Mesh, 'positions' | 'triangles' | 'weld'>): Weld {
  const known = mesh.weld ?? welds.get(mesh);
  if (known) return known;
  const made = weld(mesh.positions, mesh.triangles);
  welds.set(mesh, made);
  return made;
}

/** A mesh as a step left it: other positions (#P×3), everything else as it was, its weld too. */
export function movedMesh(mesh: Mesh, positions: Float64Array<ArrayBuffer>): Mesh {
  return { ...mesh, positions, weld: weldOf(mesh) };
}

/**
 * Merges positions that are one place, so that seams do not tear: those that are equal to the bit (−0 counts as 0; NaNs stay
 * apart) and, of those that faces use, those that differ only by rounding, see `near-places.ts`.
 *
 * Faces that repeat each other or disagree about the outside are put right for the solver, see `solved-faces.ts`.
 *
 * @param positions #P×3
 * @param triangles #F×3 indices into `positions`; indices out of range are left as they are for the core to name
 */
export function weld(positions: Float64Array, triangles: Uint32Array): Weld {
  const joined = joinPlaces(positions, triangles);
  const solved = solvedFacesOf(gather(positions, joined), joined.triangles);
  return solved ? { ...joined, solved } : joined;
}

/** The weld without a look at the faces, for those who want places alone. */
export function joinPlaces(positions: Float64Array, triangles: Uint32Array): Weld {
  const exact = weldEqual(positions, triangles);
  const firstOfPlace = joinNearPlaces(gather(positions, exact), exact.triangles);
  return firstOfPlace ? weldNear(positions, triangles, exact, firstOfPlace) : exact;
}

function weldEqual(positions: Float64Array, triangles: Uint32Array): Weld {
  const count = positions.length / 3;
  const table = new PositionTable(positions);
  const vertexOfPosition = new Uint32Array(count);
  const firstPosition = new Uint32Array(count);
  let vertices = 0;
  for (let p = 0; p < count; p++) {
    const twin = table.findOrInsert(p);
    if (twin === p) {
      firstPosition[vertices] = p;
      vertexOfPosition[p] = vertices++;
    } else {
      vertexOfPosition[p] = vertexOfPosition[twin]!;
    }
  }
  const positionOfVertex = firstPosition.slice(0, vertices);
  return { vertexOfPosition, positionOfVertex, triangles: renamed(triangles, vertexOfPosition) };
}

/** @param firstOfPlace #V of the exact weld: the first vertex in the place of each */
function weldNear(
  positions: Float64Array,
  triangles: Uint32Array,
  exact: Weld,
  firstOfPlace: Uint32Array,
): Weld {
  const joined = new Uint32Array(firstOfPlace.length);
  let vertices = 0;
  for (let v = 0; v < joined.length; v++)
    joined[v] = firstOfPlace[v] === v ? vertices++ : joined[firstOfPlace[v]!]!;
  const positionOfVertex = exact.positionOfVertex.filter((_, v) => firstOfPlace[v] === v);
  const vertexOfPosition = exact.vertexOfPosition.map((v) => joined[v]!);
  const apart = Uint32Array.from(vertexOfPosition.keys()).filter(
    (p) => firstOfPlace[exact.vertexOfPosition[p]!] !== exact.vertexOfPosition[p],
  );
  const offsets = new Float64Array(3 * apart.length);
  apart.forEach((p, i) => {
    const first = 3 * positionOfVertex[vertexOfPosition[p]!]!;
    for (let axis = 0; axis < 3; axis++)
      offsets[3 * i + axis] = positions[3 * p + axis]! - positions[first + axis]!;
  });
  const near = { places: firstOfPlace.length - vertices, positions: apart, offsets };
  return { vertexOfPosition, positionOfVertex, triangles: renamed(triangles, vertexOfPosition), near };
}

function renamed(triangles: Uint32Array, vertexOfPosition: Uint32Array): Uint32Array<ArrayBuffer> {
  const welded = triangles.slice() as Uint32Array<ArrayBuffer>;
  for (let c = 0; c < welded.length; c++) {
    const p = welded[c]!;
    if (p < vertexOfPosition.length) welded[c] = vertexOfPosition[p]!;
  }
  return welded;
}

/** The faces that the solver takes, #S×3 welded vertices. */
export const solvedTriangles = ({ solved, triangles }: Weld): Uint32Array<ArrayBuffer> =>
  solved?.triangles ?? triangles;

/** The same faces in source positions, #S×3. */
export function solvedSourceTriangles(mesh: Mesh): Uint32Array<ArrayBuffer> {
  const { solved } = weldOf(mesh);
  return solved ? cornersOfSolved(mesh.triangles, solved) : mesh.triangles;
}

/** How far a source position lies from the first of its vertex; nothing where it is the same place. */
export function offsetOf({ near }: Weld, position: number): Vec3 {
  const place = near ? lowerBound(near.positions, position) : 0;
  return near?.positions[place] === position ? row(near.offsets, place) : [0, 0, 0];
}

function lowerBound(rising: Uint32Array, value: number): number {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rising[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Positions of welded vertices (#V×3), each where its first source position (of #P×3) is. */
export function gather(
  positions: Float64Array,
  { positionOfVertex }: Pick<Weld, 'positionOfVertex'>,
): Float64Array<ArrayBuffer> {
  const gathered = new Float64Array(3 * positionOfVertex.length);
  for (let v = 0; v < positionOfVertex.length; v++) {
    const p = 3 * positionOfVertex[v]!;
    gathered[3 * v] = positions[p]!;
    gathered[3 * v + 1] = positions[p + 1]!;
    gathered[3 * v + 2] = positions[p + 2]!;
  }
  return gathered;
}

/**
 * Spreads positions of welded vertices (#V×3) back over the source positions (#P×3). Where the weld joined what differs by
 * rounding, each keeps its distance from the first; of a coordinate that has not moved it has its own bits.
 *
 * @param source #P×3 positions that the welded ones were gathered from
 */
export function spread(
  welded: Float64Array,
  { vertexOfPosition, positionOfVertex, near }: Pick<Weld, 'vertexOfPosition' | 'positionOfVertex' | 'near'>,
  source: Float64Array,
  into: Float64Array<ArrayBuffer> = new Float64Array(3 * vertexOfPosition.length),
): Float64Array<ArrayBuffer> {
  for (let p = 0; p < vertexOfPosition.length; p++) {
    const v = 3 * vertexOfPosition[p]!;
    into[3 * p] = welded[v]!;
    into[3 * p + 1] = welded[v + 1]!;
    into[3 * p + 2] = welded[v + 2]!;
  }
  near?.positions.forEach((p, place) => {
    const first = 3 * positionOfVertex[vertexOfPosition[p]!]!;
    for (let axis = 0; axis < 3; axis++) {
      const i = 3 * p + axis;
      if (into[i] === source[first + axis]) into[i] = source[i]!;
      else into[i] = into[i]! + near.offsets[3 * place + axis]!;
    }
  });
  return into;
}

/** Open-addressing hash table of positions by value. A `Map` of strings would be twenty times slower. */
class PositionTable {
  readonly #positions: Float64Array;
  readonly #slots: Int32Array;
  readonly #mask: number;
  readonly #scratch = new Float64Array(3);
  readonly #bits = new Int32Array(this.#scratch.buffer);

  constructor(positions: Float64Array) {
    this.#positions = positions;
    const capacity = 2 ** Math.ceil(Math.log2(Math.max(2, (positions.length / 3) * 2)));
    this.#slots = new Int32Array(capacity).fill(-1);
    this.#mask = capacity - 1;
  }

  /** The first position equal to position `p`, which is `p` itself if there was none before. */
  findOrInsert(p: number): number {
    for (let slot = this.#hash(p) & this.#mask; ; slot = (slot + 1) & this.#mask) {
      const other = this.#slots[slot]!;
      if (other < 0) {
        this.#slots[slot] = p;
        return p;
      }
      if (this.#equal(p, other)) return other;
    }
  }

  #hash(p: number): number {
    for (let axis = 0; axis < 3; axis++) this.#scratch[axis] = this.#positions[3 * p + axis]! + 0; // −0 → 0
    let hash = 0;
    for (let word = 0; word < 6; word++)
      hash = Math.imul(hash ^ this.#bits[word]!, 0x9e3779b1) ^ (hash >>> 15);
    return hash ^ (hash >>> 13);
  }

  #equal(p: number, q: number): boolean {
    const x = this.#positions;
    return x[3 * p] === x[3 * q] && x[3 * p + 1] === x[3 * q + 1] && x[3 * p + 2] === x[3 * q + 2];
  }
}
