import { cross, dot, row, type Vec3 } from '../../mesh/vectors.ts';

/** A place on a triangulated sphere. */
export interface SpherePlace {
  readonly face: number;
  /** Shares of the face's corners; they sum to 1. */
  readonly weights: Vec3;
}

/** Slack for directions that fall on an edge. */
const onEdge = -1e-12;

const cellsAcross = 16;

/**
 * Finds the triangle of a closed sphere around a direction: it walks from the answer to the last question nearby over the edge
 * that the direction lies beyond, mostly a few steps; should a walk go in circles, all triangles are tried.
 */
export class SphereLocator {
  readonly #points: Float64Array;
  readonly #triangles: Uint32Array;
  /** #F×3: the face beyond the edge from corner k to the next. */
  readonly #beyond: Int32Array;
  /** The last answer in each cell of a grid about the sphere; −1 where nothing was asked yet. */
  readonly #nearby = new Int32Array(cellsAcross ** 3).fill(-1);
  #last = 0;

  /** @param points unit, #V×3   @param triangles counter-clockwise from outside, #F×3 */
  constructor(points: Float64Array, triangles: Uint32Array) {
    this.#points = points;
    this.#triangles = triangles;
    this.#beyond = facesBeyond(triangles, points.length / 3);
  }

  locate(direction: Vec3): SpherePlace {
    const faces = this.#triangles.length / 3;
    const cell = cellOf(direction);
    if (this.#nearby[cell]! >= 0) this.#last = this.#nearby[cell]!;
    const place = this.#walk(direction, faces) ?? this.#search(direction);
    this.#nearby[cell] = place.face;
    return place;
  }

  #walk(direction: Vec3, faces: number): SpherePlace | null {
    for (let step = 0; step < 200 && step < faces; step++) {
      const sides = this.#sides(this.#last, direction);
      const worst = leastOf(sides);
      const ahead = dot(direction, row(this.#points, this.#triangles[3 * this.#last]!)) > 0;
      if (sides[worst]! >= onEdge && ahead) return { face: this.#last, weights: shares(sides) };
      const next = this.#beyond[3 * this.#last + worst]!;
      if (next < 0) break;
      this.#last = next;
    }
    return null;
  }

  #search(direction: Vec3): SpherePlace {
    let best = { face: 0, least: -Infinity };
    for (let face = 0; face < this.#triangles.length / 3; face++) {
      if (dot(direction, row(this.#points, this.#triangles[3 * face]!)) <= 0) continue;
      const sides = this.#sides(face, direction);
      const least = sides[leastOf(sides)]!;
      if (least > best.least) best = { face, least };
      if (least >= 0) break;
    }
    this.#last = best.face;
    return { face: best.face, weights: shares(this.#sides(best.face, direction)) };
  }

  /** How far inside each edge the direction lies: volumes with the edge, negative beyond it. */
  #sides(face: number, direction: Vec3): Vec3 {
    const corners = this.#triangles;
    const a = row(this.#points, corners[3 * face]!);
    const b = row(this.#points, corners[3 * face + 1]!);
    const c = row(this.#points, corners[3 * face + 2]!);
    return [dot(cross(a, b), direction), dot(cross(b, c), direction), dot(cross(c, a), direction)];
  }
}

function cellOf(direction: Vec3): number {
  const along = (axis: 0 | 1 | 2): number => {
    const cell = Math.floor(((direction[axis] + 1) / 2) * cellsAcross);
    return Math.max(0, Math.min(cellsAcross - 1, cell));
  };
  return (along(0) * cellsAcross + along(1)) * cellsAcross + along(2);
}

function leastOf([ab, bc, ca]: Vec3): 0 | 1 | 2 {
  if (ab <= bc && ab <= ca) return 0;
  return bc <= ca ? 1 : 2;
}

/** A corner's share is the volume with the edge across from it. */
function shares([ab, bc, ca]: Vec3): Vec3 {
  const [a, b, c] = [Math.max(0, bc), Math.max(0, ca), Math.max(0, ab)];
  const sum = a + b + c;
  return sum > 0 ? [a / sum, b / sum, c / sum] : [1, 0, 0];
}

function facesBeyond(triangles: Uint32Array, vertices: number): Int32Array {
  const faceOf = new Map<number, number>();
  const next = (corner: number): number => (corner % 3 === 2 ? corner - 2 : corner + 1);
  for (let corner = 0; corner < triangles.length; corner++)
    faceOf.set(triangles[corner]! * vertices + triangles[next(corner)]!, Math.floor(corner / 3));
  return Int32Array.from(
    triangles,
    (from, corner) => faceOf.get(triangles[next(corner)]! * vertices + from) ?? -1,
  );
}
