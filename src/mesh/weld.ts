import type { Mesh, Weld } from './mesh.ts';

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
 * Merges positions that are equal to the bit (−0 counts as 0; NaNs stay apart), so that seams do not tear.
 *
 * @param positions #P×3
 * @param triangles #F×3 indices into `positions`; indices out of range are left as they are for the core to name
 */
export function weld(positions: Float64Array, triangles: Uint32Array): Weld {
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
  const welded = triangles.slice() as Uint32Array<ArrayBuffer>;
  for (let c = 0; c < welded.length; c++) {
    const p = welded[c]!;
    if (p < count) welded[c] = vertexOfPosition[p]!;
  }
  return { vertexOfPosition, positionOfVertex: firstPosition.slice(0, vertices), triangles: welded };
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

/** Spreads positions of welded vertices (#V×3) back over the source positions (#P×3). */
export function spread(
  welded: Float64Array,
  { vertexOfPosition }: Pick<Weld, 'vertexOfPosition'>,
  into: Float64Array<ArrayBuffer> = new Float64Array(3 * vertexOfPosition.length),
): Float64Array<ArrayBuffer> {
  for (let p = 0; p < vertexOfPosition.length; p++) {
    const v = 3 * vertexOfPosition[p]!;
    into[3 * p] = welded[v]!;
    into[3 * p + 1] = welded[v + 1]!;
    into[3 * p + 2] = welded[v + 2]!;
  }
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
