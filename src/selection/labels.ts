/** A set cut into pieces that do not overlap, numbered from 0. */
export interface Labels {
  /** The piece of each member. */
  readonly of: Uint32Array;
  readonly count: number;
  /** `count` + 1, where the members of each piece begin in `members`. */
  readonly start: Uint32Array;
  /** Rising within each piece. */
  readonly members: Uint32Array;
}

/** @param of the piece of each member, below `count` */
export function labelled(of: Uint32Array, count: number): Labels {
  const next = new Uint32Array(count + 2);
  for (let i = 0; i < of.length; i++) next[of[i]! + 2]! += 1;
  for (let piece = 0; piece <= count; piece++) next[piece + 1]! += next[piece]!;
  const members = new Uint32Array(of.length);
  for (let i = 0; i < of.length; i++) {
    const piece = of[i]! + 1;
    members[next[piece]!] = i;
    next[piece]! += 1;
  }
  return { of, count, start: next.subarray(0, count + 1), members };
}

/** The members of one piece, a view. */
export function membersOf({ start, members }: Labels, piece: number): Uint32Array {
  return members.subarray(start[piece]!, start[piece + 1]!);
}
