import { type Affine, applied } from '../mesh/affine.ts';
import { add, distance, doubledAreaVector, length, row, scale, unit, type Vec3 } from '../mesh/vectors.ts';
import type { Handles } from '../methods/values/handles.ts';
import type { Group } from '../recipe/index.ts';

/** Positions of the file that a person holds or moves as one. */
export interface HandleGroup {
  readonly name: string;
  readonly vertices: readonly number[];
  /** One of them at least has a target that is not where it was. */
  readonly isMoved: boolean;
}

export const noHandles: Handles = Object.freeze({ vertices: [], targets: [] });

/** Handles with those that stay among the others, their own places for targets. @param rest #P×3, the step's rest shape */
export function spelledOut(handles: Handles, rest: ArrayLike<number>): Handles {
  const { fixed, ...others } = handles;
  return fixed ? withHandles(others, fixed, rest) : handles;
}

/**
 * The handles by the groups that they are in; those in none are one group of what is held and one of what is moved.
 *
 * @param rest #P×3, the step's rest shape
 */
export function handleGroups(
  { vertices, targets }: Handles,
  groups: readonly Group[],
  rest: ArrayLike<number>,
): readonly HandleGroup[] {
  const moved = new Map(vertices.map((vertex, k) => [vertex, !isAt(rest, vertex, targets[k]!)]));
  const left = new Set(vertices);
  const found: HandleGroup[] = [];
  const take = (name: string, members: readonly number[]) => {
    for (const vertex of members) left.delete(vertex);
    if (members.length > 0)
      found.push({ name, vertices: members, isMoved: members.some((vertex) => moved.get(vertex)) });
  };
  for (const group of groups) {
    const members = group.vertices.filter((vertex) => left.has(vertex));
    if (members.length > 0) take(group.name, members);
  }
  const others = [...left];
  take(
    'Held',
    others.filter((vertex) => !moved.get(vertex)),
  );
  take(
    'Moved',
    others.filter((vertex) => moved.get(vertex)),
  );
  return found;
}

/** Puts handles on vertices, in place of those that they had. @param places #P×3, where each is to go */
export function withHandles(
  handles: Handles,
  vertices: readonly number[],
  places: ArrayLike<number>,
): Handles {
  const kept = withoutHandles(handles, vertices);
  return {
    vertices: [...kept.vertices, ...vertices],
    targets: [...kept.targets, ...vertices.map((vertex) => row(places, vertex))],
  };
}

/** Lets vertices go. */
export function withoutHandles({ vertices, targets }: Handles, gone: Iterable<number>): Handles {
  const isGone = new Set(gone);
  const stays = vertices.map((vertex) => !isGone.has(vertex));
  if (stays.every(Boolean)) return { vertices, targets };
  return { vertices: vertices.filter((_, k) => stays[k]), targets: targets.filter((_, k) => stays[k]) };
}

/** Moves the targets of some vertices. */
export function movedHandles({ vertices, targets }: Handles, group: Iterable<number>, by: Affine): Handles {
  const isMoved = new Set(group);
  return {
    vertices,
    targets: targets.map((target, k) => (isMoved.has(vertices[k]!) ? applied(by, target) : target)),
  };
}

/** The middle of some vertices' targets. */
export function targetCenter({ vertices, targets }: Handles, group: readonly number[]): Vec3 {
  const isMember = new Set(group);
  return centerOf(targets.filter((_, k) => isMember.has(vertices[k]!)));
}

/** The middle of some vertices in a shape (#P×3). */
export function centerIn(shape: ArrayLike<number>, group: readonly number[]): Vec3 {
  return centerOf(group.map((vertex) => row(shape, vertex)));
}

/**
 * Where a patch of a surface looks on the whole, unit; zero where it looks everywhere.
 *
 * @param shape #P×3   @param triangles #F×3
 */
export function outlook(
  shape: ArrayLike<number>,
  triangles: ArrayLike<number>,
  patch: readonly number[],
): Vec3 {
  const isMember = new Set(patch);
  let sum: Vec3 = [0, 0, 0];
  let area = 0;
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = [triangles[corner]!, triangles[corner + 1]!, triangles[corner + 2]!];
    if (!isMember.has(a) || !isMember.has(b) || !isMember.has(c)) continue;
    const vector = doubledAreaVector(row(shape, a), row(shape, b), row(shape, c));
    sum = add(sum, vector);
    area += length(vector);
  }
  return length(sum) > agreement * area ? unit(sum) : [0, 0, 0];
}

/** Of the area of a patch, how much its faces have to agree on for it to look anywhere: those of a tube or a ball do not. */
const agreement = 0.5;

/**
 * What a thing stands on, or hangs from where its lower end was taken: something has to stay for the rest to be pulled against.
 *
 * @param shape #P×3   @param candidates positions that may be held   @param taken those that are pulled   @param up 1 or 2, the axis
 */
export function footing(
  shape: ArrayLike<number>,
  candidates: Iterable<number>,
  taken: readonly number[],
  up: 1 | 2,
): readonly number[] {
  const isTaken = new Set(taken);
  const free = [...candidates].filter((position) => !isTaken.has(position));
  const height = (position: number) => shape[3 * position + up]!;
  const low = free.reduce((least, position) => Math.min(least, height(position)), Infinity);
  const high = free.reduce((most, position) => Math.max(most, height(position)), -Infinity);
  const middle = taken.reduce((sum, position) => sum + height(position), 0) / Math.max(1, taken.length);
  const reach = footingShare * (high - low);
  const isBelow = middle - low < (high - low) / 4;
  const base = free.filter((position) =>
    isBelow ? height(position) >= high - reach : height(position) <= low + reach,
  );
  return base.length <= flatShare * free.length ? base : farthest(shape, free, taken);
}

/** What lies flat stands on all of it: its outermost is held instead, as seen from what is taken. */
function farthest(shape: ArrayLike<number>, free: readonly number[], taken: readonly number[]) {
  const middle = centerOf(taken.map((position) => row(shape, position)));
  const away = free.map((position) => distance(row(shape, position), middle));
  const reach = (1 - footingShare) * away.reduce((most, one) => Math.max(most, one), 0);
  return free.filter((_, k) => away[k]! >= reach);
}

/** Of the height, or of the way to the outermost. */
const footingShare = 0.05;

/** What stands on more of its positions than this lies flat. */
const flatShare = 0.9;

function centerOf(points: readonly Vec3[]): Vec3 {
  const sum = points.reduce<Vec3>(add, [0, 0, 0]);
  return scale(sum, 1 / Math.max(1, points.length));
}

function isAt(shape: ArrayLike<number>, vertex: number, [x, y, z]: Vec3): boolean {
  return shape[3 * vertex] === x && shape[3 * vertex + 1] === y && shape[3 * vertex + 2] === z;
}
