/** A file's faces, each set of three vertices once. */
export interface DistinctFaces {
  /** #S faces of the file, rising: the first of those that have the same vertices. */
  readonly faceOf: Uint32Array<ArrayBuffer>;
  /** #F, which of those each face of the file is or repeats. */
  readonly solvedOf: Uint32Array<ArrayBuffer>;
}

/** @param triangles #F×3; a face that uses a vertex twice repeats nothing */
export function distinctFaces(triangles: Uint32Array): DistinctFaces {
  const faces = triangles.length / 3;
  const table = new FaceTable(triangles);
  const faceOf = new Uint32Array(faces);
  const solvedOf = new Uint32Array(faces);
  let count = 0;
  for (let face = 0; face < faces; face++) {
    const first = table.findOrInsert(face);
    if (first !== face) solvedOf[face] = solvedOf[first]!;
    else {
      faceOf[count] = face;
      solvedOf[face] = count++;
    }
  }
  return { faceOf: faceOf.slice(0, count), solvedOf };
}

/** Open-addressing hash table of faces by their three vertices in any order. */
class FaceTable {
  readonly #triangles: Uint32Array;
  readonly #slots: Int32Array;

  constructor(triangles: Uint32Array) {
    this.#triangles = triangles;
    this.#slots = new Int32Array(2 ** Math.ceil(Math.log2(triangles.length + 2))).fill(-1);
  }

  /** The first face with the same vertices, which is `face` itself if there was none before. */
  findOrInsert(face: number): number {
    const [a, b, c] = this.#sorted(face);
    if (a === b || b === c) return face;
    const mask = this.#slots.length - 1;
    const hash = Math.imul(Math.imul(Math.imul(a, 0x9e3779b1) ^ b, 0x85ebca6b) ^ (a >>> 15) ^ c, 0xc2b2ae35);
    for (let slot = (hash ^ (hash >>> 15)) & mask; ; slot = (slot + 1) & mask) {
      const other = this.#slots[slot]!;
      if (other < 0) {
        this.#slots[slot] = face;
        return face;
      }
      const [x, y, z] = this.#sorted(other);
      if (x === a && y === b && z === c) return other;
    }
  }

  #sorted(face: number): [number, number, number] {
    const [a, b, c] = [
      this.#triangles[3 * face]!,
      this.#triangles[3 * face + 1]!,
      this.#triangles[3 * face + 2]!,
    ];
    const [low, high] = [Math.min(a, b, c), Math.max(a, b, c)];
    return [low, a + b + c - low - high, high];
  }
}
