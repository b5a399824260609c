import { clipEars } from '../../src/io/ear-clipping.ts';
import { delaunay } from './delaunay.ts';
import { distance2, distanceToSegment, doubledArea, isInside, type Loop, turn, type Vec2 } from './plane.ts';

export interface Filled {
  /** Those of the loops first, loop by loop. */
  readonly points: readonly Vec2[];
  /** Corners, three by three, counter-clockwise. */
  readonly triangles: readonly number[];
}

/**
 * Even triangles inside an outline and outside its holes, with edges of about the given length inside. Sides of the loops stay
 * whole, so that regions which share a side fit.
 */
export function evenFill(loops: readonly Loop[], edge: number): Filled {
  const rim = loops.flat();
  let inner = hexagonal(loops, edge).filter((p) => isClear(p, loops, 0.62 * edge));
  let filled = insideOnly([...rim, ...inner], loops);
  for (let round = 0; round < 2 && inner.length > 0; round++) {
    inner = relaxed(filled).slice(rim.length);
    filled = insideOnly([...rim, ...inner], loops);
  }
  checkSides(filled, loops);
  return filled;
}

/** As many programs for construction write it: no point inside, triangles of any shape. */
export function fanFill(loops: readonly Loop[]): Filled {
  const points = loops.flat();
  let first = 0;
  const rings = loops.map((loop, k) => {
    const ring = loop.map((at, i): Stop => ({ vertex: first + i, at }));
    first += loop.length;
    return doubledArea(loop) > 0 === (k === 0) ? ring : ring.reverse();
  });
  let [outline, ...holes] = rings as [Stop[], ...Stop[][]];
  const rightmost = (ring: readonly Stop[]) => Math.max(...ring.map(({ at }) => at[0]));
  for (const hole of holes.toSorted((a, b) => rightmost(b) - rightmost(a))) outline = bridged(outline, hole);
  const flat = Float64Array.from(outline.flatMap(({ at }) => at));
  const { triangles } = clipEars(flat, outline.length, 1e8);
  return { points, triangles: Array.from(triangles, (corner) => outline[corner]!.vertex) };
}

/** A corner of a ring that may pass a point twice, by places that are a little apart. */
interface Stop {
  readonly vertex: number;
  readonly at: Vec2;
}

/** One ring of an outline and a hole, joined by the shortest bridge that crosses neither. */
function bridged(outline: readonly Stop[], hole: readonly Stop[]): Stop[] {
  const sides = [outline, hole].flatMap((ring) =>
    ring.map(({ at }, i) => [at, ring[(i + 1) % ring.length]!.at] as const),
  );
  const bridges = outline.flatMap((p, i) =>
    hole.map((q, j) => ({ i, j, p: p.at, q: q.at, reach: distance2(p.at, q.at) })),
  );
  const { i, j, p, q, reach } = bridges
    .toSorted((a, b) => a.reach - b.reach)
    .find(
      ({ p, q }) =>
        !sides.some(([a, b]) => turn(p, q, a) * turn(p, q, b) < 0 && turn(a, b, p) * turn(a, b, q) < 0),
    )!;
  // The way back is beside the way there, so that no place is passed twice.
  const gap: Vec2 = [(1e-7 * (q[1] - p[1])) / reach, (-1e-7 * (q[0] - p[0])) / reach];
  const back = ({ vertex, at }: Stop): Stop => ({ vertex, at: [at[0] + gap[0], at[1] + gap[1]] });
  return [
    ...outline.slice(0, i + 1),
    ...hole.slice(j),
    ...hole.slice(0, j),
    back(hole[j]!),
    back(outline[i]!),
    ...outline.slice(i + 1),
  ];
}

/** A number in −0.5…0.5 that is always the same for the same key. */
const noise = (key: number): number => Math.abs((Math.sin(12.9898 * key + 4.1) * 43758.5453) % 1) - 0.5;

/** Points in staggered rows over the box of the outline, a little out of line as in meshes that were not ruled. */
function hexagonal(loops: readonly Loop[], edge: number): Vec2[] {
  const [xs, ys] = [loops[0]!.map(([x]) => x), loops[0]!.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const points: Vec2[] = [];
  for (let j = 0; low + j * edge * Math.sqrt(0.75) < high; j++)
    for (let i = 0; left + i * edge < right; i++) {
      const key = 2 * points.length;
      points.push([
        left + (i + (j % 2) / 2 + 0.1 * noise(key)) * edge,
        low + (j * Math.sqrt(0.75) + 0.1 * noise(key + 1)) * edge,
      ]);
    }
  return points;
}

function isClear(p: Vec2, loops: readonly Loop[], gap: number): boolean {
  if (!isInside(p, loops)) return false;
  return loops.every((loop) => {
    let a = loop.at(-1)!;
    for (const b of loop) {
      if (distanceToSegment(p, a, b) < gap) return false;
      a = b;
    }
    return true;
  });
}

/** The Delaunay triangles whose middle lies inside. Points that lie in line are put out of it by a millionth for that. */
function insideOnly(points: readonly Vec2[], loops: readonly Loop[]): Filled {
  const shift = 1e-6 * distance2(loops[0]![0]!, loops[0]![1]!);
  const moved = points.map(([x, y], k): Vec2 => [x + shift * noise(2 * k), y + shift * noise(2 * k + 1)]);
  let first = 0;
  const movedLoops = loops.map((loop) => {
    first += loop.length;
    return moved.slice(first - loop.length, first);
  });
  const corners = delaunay(moved);
  const triangles: number[] = [];
  for (let c = 0; c < corners.length; c += 3) {
    const [p, q, r] = [moved[corners[c]!]!, moved[corners[c + 1]!]!, moved[corners[c + 2]!]!];
    const middle: Vec2 = [(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3];
    if (isInside(middle, movedLoops)) triangles.push(...corners.slice(c, c + 3));
  }
  return { points, triangles };
}

/** Each point in the middle of its neighbours. */
function relaxed({ points, triangles }: Filled): Vec2[] {
  const sums = points.map(() => [0, 0, 0]);
  for (const [corner, v] of triangles.entries()) {
    const next = triangles[corner % 3 === 2 ? corner - 2 : corner + 1]!;
    for (const [from, to] of [
      [v, next],
      [next, v],
    ] as const) {
      const sum = sums[from]!;
      sum[0]! += points[to]![0];
      sum[1]! += points[to]![1];
      sum[2]! += 1;
    }
  }
  return sums.map(([x, y, count]): Vec2 => [x! / count!, y! / count!]);
}

function checkSides({ triangles }: Filled, loops: readonly Loop[]): void {
  const edges = new Set(
    triangles.map((v, corner) => {
      const w = triangles[corner % 3 === 2 ? corner - 2 : corner + 1]!;
      return `${Math.min(v, w)} ${Math.max(v, w)}`;
    }),
  );
  let first = 0;
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i++) {
      const [v, w] = [first + i, first + ((i + 1) % loop.length)];
      if (!edges.has(`${Math.min(v, w)} ${Math.max(v, w)}`)) {
        throw new Error(`The side at ${loop[i]} is lost: sample the outline more finely.`);
      }
    }
    first += loop.length;
  }
}
