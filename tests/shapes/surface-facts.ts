import { cross, dot, row, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { TestMesh } from '../fixtures/subdivision.ts';
import { faceVectors } from '../fixtures/surfaces.ts';

/** Two faces at an edge. */
export interface Pair {
  readonly faces: readonly [number, number];
  readonly edge: readonly [number, number];
  /** The vertices opposite to the edge. */
  readonly opposite: readonly [number, number];
  /** Degrees between the normals. */
  readonly angle: number;
}

/** What measures need to know of a mesh before it was reshaped. */
export class SurfaceFacts {
  readonly mesh: TestMesh;
  readonly normals: readonly Vec3[];
  readonly pairs: readonly Pair[];
  readonly diagonal: number;
  /** Faces that are no slivers: their height is above a thousandth of their longest side. */
  readonly sound: readonly boolean[];

  constructor(mesh: TestMesh) {
    this.mesh = mesh;
    this.normals = normalsOf(mesh);
    this.pairs = pairsOf(mesh, this.normals);
    this.diagonal = diagonalOf(mesh.positions);
    this.sound = Array.from({ length: mesh.triangles.length / 3 }, (_, face) => slimness(mesh, face) > 1e-3);
  }

  /** The vertices of flat parts of eight faces and more. */
  planes(): number[][] {
    const flat = regions(
      this.normals.length,
      this.pairs.filter(({ angle }) => angle < 0.01),
    );
    return flat.filter((faces) => faces.length >= 8).map((faces) => this.#verticesOf(faces));
  }

  /** Straight creases of three vertices and more: their vertices in order. */
  straightLines(): number[][] {
    const next = new Map<number, number[]>();
    for (const { edge, angle } of this.pairs) {
      if (angle < 40) continue;
      for (const [v, w] of [edge, edge.toReversed()] as [number, number][])
        next.set(v, [...(next.get(v) ?? []), w]);
    }
    const lines: number[][] = [];
    const done = new Set<string>();
    for (const [from, ways] of next)
      for (const to of ways) {
        const line = [from, to];
        if (this.#ahead(next, to, from) !== undefined && this.#ahead(next, from, to) !== undefined) continue;
        for (
          let on = this.#ahead(next, from, to);
          on !== undefined;
          on = this.#ahead(next, line.at(-2)!, line.at(-1)!)
        ) {
          line.push(on);
        }
        const key = `${Math.min(from, line.at(-1)!)} ${Math.max(from, line.at(-1)!)}`;
        if (line.length < 3 || done.has(key)) continue;
        done.add(key);
        lines.push(line);
      }
    return lines;
  }

  /** The vertex that goes on straight after a step. */
  #ahead(next: ReadonlyMap<number, readonly number[]>, from: number, at: number): number | undefined {
    const way = (v: number, w: number) =>
      unit(subtract(row(this.mesh.positions, w), row(this.mesh.positions, v)));
    const straight = Math.cos((2 * Math.PI) / 180);
    return next.get(at)!.find((to) => to !== from && dot(way(from, at), way(at, to)) > straight);
  }

  #verticesOf(faces: readonly number[]): number[] {
    return [...new Set(faces.flatMap((face) => [...this.mesh.triangles.subarray(3 * face, 3 * face + 3)]))];
  }
}

export const normalsOf = (mesh: TestMesh): Vec3[] => faceVectors(mesh).map(unit);

export function degreesBetween(a: Vec3, b: Vec3): number {
  return (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / Math.PI;
}

export function diagonalOf(positions: Float64Array): number {
  const sides = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let p = axis; p < positions.length; p += 3) {
      low = Math.min(low, positions[p]!);
      high = Math.max(high, positions[p]!);
    }
    return high - low;
  });
  return Math.hypot(...sides);
}

/** Squared sides and doubled area of a face. */
function sizesOf({ positions, triangles }: TestMesh, face: number): { squares: number[]; doubled: number } {
  const corners = [0, 1, 2].map((k) => row(positions, triangles[3 * face + k]!));
  const sides = corners.map((p, k) => subtract(corners[(k + 1) % 3]!, p));
  return {
    squares: sides.map((side) => dot(side, side)),
    doubled: Math.hypot(...cross(sides[0]!, sides[1]!)),
  };
}

function slimness(mesh: TestMesh, face: number): number {
  const { squares, doubled } = sizesOf(mesh, face);
  return doubled / Math.max(...squares);
}

/** 1 for an equilateral face, 0 for one without area. */
export function qualityOf(mesh: TestMesh, face: number): number {
  const { squares, doubled } = sizesOf(mesh, face);
  return (2 * Math.sqrt(3) * doubled) / squares.reduce((a, b) => a + b);
}

function pairsOf({ triangles }: TestMesh, normals: readonly Vec3[]): Pair[] {
  const sides = new Map<string, number[]>();
  const next = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [v, w] = [triangles[corner]!, triangles[next(corner)]!];
    const key = `${Math.min(v, w)} ${Math.max(v, w)}`;
    sides.set(key, [...(sides.get(key) ?? []), corner]);
  }
  return [...sides.values()].flatMap((corners) =>
    corners.flatMap((a, k) =>
      corners.slice(k + 1).map((b): Pair => {
        const faces = [Math.floor(a / 3), Math.floor(b / 3)] as const;
        const sign = triangles[a] === triangles[b] ? -1 : 1;
        return {
          faces,
          edge: [triangles[a]!, triangles[next(a)]!],
          opposite: [triangles[next(next(a))]!, triangles[next(next(b))]!],
          angle: degreesBetween(normals[faces[0]]!, scale(normals[faces[1]]!, sign)),
        };
      }),
    ),
  );
}

/** Faces that pairs connect, group by group. */
export function regions(count: number, pairs: readonly Pair[]): number[][] {
  const head = Array.from({ length: count }, (_, face) => face);
  const find = (face: number): number => {
    let at = face;
    while (head[at] !== at) at = head[at] = head[head[at]!]!;
    return at;
  };
  for (const { faces } of pairs) head[find(faces[0])] = find(faces[1]);
  const groups = new Map<number, number[]>();
  for (const face of head.keys()) {
    const group = groups.get(find(face));
    if (group) group.push(face);
    else groups.set(find(face), [face]);
  }
  return [...groups.values()];
}
