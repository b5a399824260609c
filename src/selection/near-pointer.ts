import { border, smooth } from './features.ts';
import type { SelectableMesh } from './selectable.ts';
import { faceOfSide, nextSide, none, sideAcross } from './topology.ts';

/** A place of the screen, in CSS pixels. */
export type ScreenPoint = readonly [x: number, y: number];

/** Where a pointer meets a surface. */
export interface Aim {
  /** Of the faces that the solver takes, #S. */
  readonly face: number;
  /** Shares of the corners in the place that is met; they add up to 1. */
  readonly weights: readonly [number, number, number];
  readonly pointer: ScreenPoint;
  /** Where a welded vertex is on the screen; NaN where it is not. */
  readonly project: (vertex: number) => ScreenPoint;
  /** Pixels from the pointer within which a line is meant, and not what lies beside it. */
  readonly reach: number;
}

export interface NearEdge {
  readonly edge: number;
  readonly isBorder: boolean;
}

/** So many faces are looked at for a line near the pointer: where more are within reach, nobody could tell lines apart. */
const mostFaces = 800;

/** The feature edge that is nearest to the pointer, of those within reach; a border comes before a crease at the same distance. */
export function nearestFeature(surface: SelectableMesh, aim: Aim): NearEdge | null {
  const { topology, features, visits } = surface;
  const waiting = [aim.face];
  visits.begin();
  visits.face(aim.face);
  let nearest = none;
  let least = aim.reach;
  for (let at = 0; at < waiting.length && at < mostFaces; at++) {
    for (let side = 3 * waiting[at]!; side < 3 * waiting[at]! + 3; side++) {
      const distance = distanceToSide(surface, aim, side);
      if (!(distance <= aim.reach)) continue;
      const edge = topology.edgeOfSide[side]!;
      if (edge !== none && features[edge] !== smooth && isNearer(features, edge, distance, nearest, least))
        [nearest, least] = [edge, distance];
      const across = sideAcross(topology, side);
      if (across !== none && visits.face(faceOfSide(across))) waiting.push(faceOfSide(across));
    }
  }
  return nearest === none ? null : { edge: nearest, isBorder: features[nearest] === border };
}

function isNearer(
  features: Uint8Array,
  edge: number,
  distance: number,
  nearest: number,
  least: number,
): boolean {
  if (nearest === none || distance < least) return true;
  return distance === least && features[edge] === border && features[nearest] !== border;
}

/** The edge of the face that is nearest to the pointer; `none` for a face that uses a vertex twice there. */
export function nearestSide(surface: SelectableMesh, aim: Aim): number {
  let nearest = 3 * aim.face;
  let least = Infinity;
  for (let side = 3 * aim.face; side < 3 * aim.face + 3; side++) {
    const distance = distanceToSide(surface, aim, side);
    if (distance < least) [nearest, least] = [side, distance];
  }
  return surface.topology.edgeOfSide[nearest]!;
}

/** The corner of the face that is nearest to the pointer. */
export function nearestVertex({ topology }: SelectableMesh, { face, pointer, project }: Aim): number {
  let nearest = topology.triangles[3 * face]!;
  let least = Infinity;
  for (const v of topology.triangles.subarray(3 * face, 3 * face + 3)) {
    const [x, y] = project(v);
    const distance = Math.hypot(x - pointer[0], y - pointer[1]);
    if (distance < least) [nearest, least] = [v, distance];
  }
  return nearest;
}

function distanceToSide(
  { topology: { triangles } }: SelectableMesh,
  { pointer, project }: Aim,
  side: number,
): number {
  const [ax, ay] = project(triangles[side]!);
  const [bx, by] = project(triangles[nextSide(side)]!);
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const along = square > 0 ? ((pointer[0] - ax) * dx + (pointer[1] - ay) * dy) / square : 0;
  const share = Math.max(0, Math.min(1, along));
  return Math.hypot(pointer[0] - ax - share * dx, pointer[1] - ay - share * dy);
}
