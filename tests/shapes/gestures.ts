import { add, distance, row, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { part, type Rotation, type Shape, turnedPoint } from './shape.ts';

/** One part is held and another moves away from it along an axis of the shape: their distance is multiplied. */
export interface Stretching {
  readonly held: string;
  readonly moved: string;
  readonly factor: number;
  /** Whether only the vertex in the middle of either part is a handle; else all of both. */
  readonly points?: boolean;
}

/** The handles of a gesture on a shape as it was made; {@link turnedHandles} for one that lies otherwise. */
export function stretched(shape: Shape, { held, moved, factor, points = false }: Stretching): Handles {
  const [still, moving] = [held, moved].map((name) => part(shape, name)) as [
    readonly number[],
    readonly number[],
  ];
  const [from, to] = [still, moving].map((vertices) => middleOf(shape, vertices)) as [Vec3, Vec3];
  const way = scale(along(subtract(to, from)), factor - 1);
  const taken = (vertices: readonly number[]) => (points ? [nearest(shape, vertices)] : vertices);
  return together(movedBy(shape, taken(still), [0, 0, 0]), movedBy(shape, taken(moving), way));
}

/** Vertices that all move the same way. */
export function movedBy({ positions }: Shape, vertices: readonly number[], way: Vec3): Handles {
  return { vertices, targets: vertices.map((v) => add(row(positions, v), way)) };
}

/** The axis part of a vector that is its longest. */
function along(vector: Vec3): Vec3 {
  const most = Math.max(...vector.map(Math.abs));
  return vector.map((x) => (Math.abs(x) === most ? x : 0)) as unknown as Vec3;
}

/** The handles of a gesture with its shape turned. */
export function turnedHandles({ vertices, targets }: Handles, by: Rotation): Handles {
  return { vertices, targets: targets.map((target) => turnedPoint(target, by)) };
}

export function together(...all: readonly Handles[]): Handles {
  return {
    vertices: all.flatMap(({ vertices }) => vertices),
    targets: all.flatMap(({ targets }) => targets),
  };
}

/** The middle of the box around some vertices. */
export function middleOf({ positions }: Shape, vertices: readonly number[]): Vec3 {
  const points = vertices.map((v) => row(positions, v));
  return [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]!);
    return (Math.min(...values) + Math.max(...values)) / 2;
  }) as unknown as Vec3;
}

/** The vertex of a part that is nearest to its middle. */
export function nearest(shape: Shape, vertices: readonly number[]): number {
  const middle = middleOf(shape, vertices);
  const reach = (v: number) => distance(row(shape.positions, v), middle);
  return vertices.reduce((best, v) => (reach(v) < reach(best) - 1e-9 ? v : best));
}
