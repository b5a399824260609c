import { cross, distance, dot, row, scale, subtract, unit, type Vec3 } from '../../../src/mesh/vectors.ts';
import type { Handles } from '../../../src/methods/values/handles.ts';
import { fittedRound } from '../fits.ts';
import { part, type Round, type Shape } from '../shape.ts';
import type { Wall } from '../walls.ts';

/**
 * What of a shape a gesture does not change by itself, so that it is to keep its size: cylinders, bevels and walls of
 * which no handles are pulled apart, across the axis or the wall.
 */
export class Asked {
  readonly #shape: Shape;
  /** Where handles go, by vertex. */
  readonly #moves: ReadonlyMap<number, Vec3>;

  constructor(shape: Shape, { vertices, targets }: Handles) {
    this.#shape = shape;
    this.#moves = new Map(
      vertices.map((v, k) => [v, subtract(targets[k]!, row(shape.positions, v))] as const),
    );
  }

  rounds(): Round[] {
    const all = this.#shape.rounds;
    const apart = all.filter(({ vertices, axis }) => this.#isPulledApart(vertices, axis && across(axis)));
    // The other side of a wall that is widened goes with it.
    return all.filter((round) => !apart.some((other) => other === round || this.#isBehind(round, other)));
  }

  bevels(): string[] {
    return this.#shape.bevels.filter((name) => !this.#isPulledApart(part(this.#shape, name)));
  }

  /** A wall is pulled apart where handles of one side move away from those of the other. */
  isWallAsked({ face, behind }: Wall): boolean {
    const { positions, triangles } = this.#shape;
    const [here, there] = [face, behind].map((of) => [...triangles.subarray(3 * of, 3 * of + 3)]);
    const [a, b, c] = here!.map((v) => row(positions, v)) as [Vec3, Vec3, Vec3];
    const through = along(cross(subtract(b, a), subtract(c, a)));
    const isHeld = [here!, there!].every((side) => side.some((v) => this.#moves.has(v)));
    return !isHeld || !this.#isPulledApart([...here!, ...there!], through);
  }

  #isPulledApart(vertices: readonly number[], seen: (move: Vec3) => Vec3 = (move) => move): boolean {
    const moves = vertices.flatMap((v) => {
      const move = this.#moves.get(v);
      return move ? [seen(move)] : [];
    });
    return moves.some((move) => distance(move, moves[0]!) > 1e-9);
  }

  #isBehind(round: Round, other: Round): boolean {
    const { positions } = this.#shape;
    if (!round.axis || !other.axis || Math.abs(dot(round.axis, other.axis)) < 0.999) return false;
    const [a, b] = [round, other].map(({ vertices, axis }) => fittedRound(positions, vertices, axis));
    const ratio = a!.radius / b!.radius;
    const apart = subtract(middle(positions, round.vertices), middle(positions, other.vertices));
    const off = Math.hypot(...cross(apart, unit(other.axis)));
    return off < 0.05 * b!.radius && ratio > 0.7 && ratio < 1.43;
  }
}

const along =
  (axis: Vec3) =>
  (vector: Vec3): Vec3 =>
    scale(unit(axis), dot(vector, unit(axis)));

const across =
  (axis: Vec3) =>
  (vector: Vec3): Vec3 =>
    subtract(vector, along(axis)(vector));

function middle(positions: Float64Array, vertices: readonly number[]): Vec3 {
  return [0, 1, 2].map(
    (axis) => vertices.reduce((sum, v) => sum + positions[3 * v + axis]!, 0) / vertices.length,
  ) as unknown as Vec3;
}
