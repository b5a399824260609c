import { type Pair, regions, type SurfaceFacts } from '../surface-facts.ts';

/** A flat part of a surface, as a person sees one: faces that lie in one plane. */
export interface Facet {
  readonly faces: readonly number[];
  /** Where it meets others: which, and in what pair of faces, the first of which is its own. */
  readonly sides: readonly { readonly beyond: number; readonly pair: Pair }[];
}

/** What bends by less is flat, in degrees: files in 32 bits have this much in small faces, and more in slivers. */
const flat = { sound: 0.3, sliver: 2 } as const;

/** The flat parts of a surface. */
export function facetsOf({ normals, pairs, sound }: SurfaceFacts): Facet[] {
  const joined = pairs.filter(
    ({ angle, faces: [a, b] }) => angle < (sound[a] && sound[b] ? flat.sound : flat.sliver),
  );
  const groups = regions(normals.length, joined);
  const facetOf = new Map(groups.flatMap((faces, facet) => faces.map((face) => [face, facet] as const)));
  const sides = groups.map((): { beyond: number; pair: Pair }[] => []);
  for (const pair of pairs) {
    const [a, b] = pair.faces.map((face) => facetOf.get(face)!) as [number, number];
    if (a === b) continue;
    const { faces, opposite } = pair;
    sides[a]!.push({ beyond: b, pair });
    sides[b]!.push({
      beyond: a,
      pair: { ...pair, faces: [faces[1], faces[0]], opposite: [opposite[1], opposite[0]] },
    });
  }
  return groups.map((faces, facet) => ({ faces, sides: sides[facet]! }));
}
