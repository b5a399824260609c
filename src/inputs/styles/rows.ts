import type { Mesh } from '../../mesh/mesh.ts';
import { between, distance, type Vec3 } from '../../mesh/vectors.ts';
import { meshOf, type Triangle } from './surface.ts';

/** Collects a surface from strips between rows of points; rows that share points are joined where these are equal. */
export class RowMesh {
  readonly #points: Vec3[] = [];
  readonly #triangles: Triangle[] = [];

  /** Adds a row, from left to right seen from outside; a closed one ends with its first point. */
  add(row: readonly Vec3[]): readonly number[] {
    const first = this.#points.length;
    this.#points.push(...row);
    return row.map((_, k) => first + k);
  }

  /** Fills the strip between a row and the one above it with triangles, always along the shorter diagonal. */
  stitch(below: readonly number[], above: readonly number[]): void {
    const at = (vertex: number): Vec3 => this.#points[vertex]!;
    let i = 0;
    let j = 0;
    while (i + 1 < below.length || j + 1 < above.length) {
      const isBelow =
        j + 1 === above.length ||
        (i + 1 < below.length &&
          distance(at(below[i + 1]!), at(above[j]!)) <= distance(at(below[i]!), at(above[j + 1]!)));
      if (isBelow) this.#triangles.push([below[i]!, below[++i]!, above[j]!]);
      else this.#triangles.push([above[j + 1]!, above[j++]!, below[i]!]);
    }
  }

  mesh(): Mesh {
    return meshOf(this.#points, this.#triangles);
  }
}

/** Points at equal distances along a polyline, its ends among them. */
export function resampled(line: readonly Vec3[], intervals: number): Vec3[] {
  const ways = [0];
  for (let k = 1; k < line.length; k++) ways.push(ways[k - 1]! + distance(line[k - 1]!, line[k]!));
  const points: Vec3[] = [line[0]!];
  let k = 1;
  for (let step = 1; step < intervals; step++) {
    const way = (ways.at(-1)! * step) / intervals;
    while (ways[k]! < way) k++;
    points.push(between(line[k - 1]!, line[k]!, (way - ways[k - 1]!) / (ways[k]! - ways[k - 1]!)));
  }
  return [...points, line.at(-1)!];
}

/** Length of a polyline. */
export const lengthOf = (line: readonly Vec3[]): number =>
  line.reduce((sum, point, k) => (k === 0 ? 0 : sum + distance(line[k - 1]!, point)), 0);
