import { type FaceShape, measureFace } from './areas.ts';
import { acrossCorners, halfEdgesOf } from './half-edges.ts';
import { cross, dot, row, subtract, type Vec3 } from './vectors.ts';

/** A part keeps the way that so much of its surface looks; where less agrees and it is closed, it looks outward. */
const clearMajority = 2 / 3;

export interface Orientation {
  /** #F, 1 for faces that are to be turned. */
  readonly isTurned: Uint8Array<ArrayBuffer>;
  /** Edges whose two faces look to different sides even so, as on a Möbius strip. */
  readonly oneSidedEdges: number;
}

/**
 * Which faces are to be turned for neighbours to look the same way. Parts end at edges of one face or of more than two. A part
 * whose faces agree stays as it is, inside out too; one that cannot agree stays too, unless turning helps.
 *
 * @param positions #V×3
 * @param triangles #F×3, no two with the same vertices
 */
export function orient(positions: Float64Array, triangles: Uint32Array): Orientation {
  const across = acrossCorners(halfEdgesOf(triangles, positions.length / 3));
  const surface: Surface = { positions, triangles, across };
  const isTurned = new Uint8Array(triangles.length / 3);
  const isSeen = new Uint8Array(isTurned.length);
  let oneSidedEdges = 0;
  for (let face = 0; face < isTurned.length; face++) {
    if (isSeen[face] === 1) continue;
    const part = collectPart(face, surface, isSeen, isTurned);
    const before = sidesAgainst(part, surface, undefined);
    const after = sidesAgainst(part, surface, isTurned);
    if (after >= before) for (const member of part) isTurned[member] = 0;
    else chooseSide(part, surface, isTurned);
    oneSidedEdges += Math.min(before, after) / 2;
  }
  return { isTurned, oneSidedEdges };
}

interface Surface {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  readonly across: Uint32Array;
}

/** The faces of a part; marks those that have to be turned to look as the first does. */
function collectPart(first: number, surface: Surface, isSeen: Uint8Array, isTurned: Uint8Array): number[] {
  const { triangles, across } = surface;
  const part = [first];
  isSeen[first] = 1;
  for (let i = 0; i < part.length; i++) {
    for (let c = 3 * part[i]!; c < 3 * part[i]! + 3; c++) {
      const other = across[c]!;
      const neighbour = Math.floor(other / 3);
      if (other === triangles.length || isSeen[neighbour] === 1) continue;
      isSeen[neighbour] = 1;
      isTurned[neighbour] = isTurned[part[i]!]! ^ Number(runsAlike(triangles, c, other));
      part.push(neighbour);
    }
  }
  return part;
}

/** Whether two sides of an edge run the same way, so that their faces look to different sides. */
function runsAlike(triangles: Uint32Array, a: number, b: number): boolean {
  return triangles[a] === triangles[b];
}

/** How many sides of a part's faces run against the orientation of the neighbour there: two an edge. */
function sidesAgainst(part: number[], { triangles, across }: Surface, isTurned?: Uint8Array): number {
  let count = 0;
  for (const face of part) {
    for (let c = 3 * face; c < 3 * face + 3; c++) {
      const other = across[c]!;
      if (other === triangles.length) continue;
      const turns = isTurned ? isTurned[face]! ^ isTurned[Math.floor(other / 3)]! : 0;
      count += Number(runsAlike(triangles, c, other)) ^ turns;
    }
  }
  return count;
}

/** Turns a part's marked faces or all the others, whichever side is right. */
function chooseSide(part: number[], { positions, triangles, across }: Surface, isTurned: Uint8Array): void {
  const origin = row(positions, triangles[3 * part[0]!]!);
  const shape: FaceShape = [0, 0, 0, 0];
  const areas: [number, number] = [0, 0];
  let volume = 0;
  let isClosed = true;
  for (const face of part) {
    measureFace(positions, triangles, face, shape);
    areas[isTurned[face]!]! += shape[3];
    const [a, b, c] = [0, 1, 2].map((k) => subtract(row(positions, triangles[3 * face + k]!), origin)) as [
      Vec3,
      Vec3,
      Vec3,
    ];
    volume += (isTurned[face] ? -1 : 1) * dot(a, cross(b, c));
    for (let k = 3 * face; k < 3 * face + 3; k++) isClosed &&= across[k] !== triangles.length;
  }
  const isClear = Math.max(...areas) > clearMajority * (areas[0] + areas[1]);
  const isRight = isClosed && !isClear ? volume >= 0 : areas[0] >= areas[1];
  if (!isRight) for (const face of part) isTurned[face] = 1 - isTurned[face]!;
}
