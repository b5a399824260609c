import type { Case } from './cases.ts';
import type { Stretching } from './gestures.ts';
import type { Kept, Measures } from './measures.ts';

/** One thing that a person may notice of a reshaped shape. */
interface Limit {
  /** What is kept, and how well at least. */
  readonly title: string;
  /** Whether a shape has such a thing at all; absent where every shape has. */
  readonly concerns?: (of: Measures) => boolean;
  /** A few words on what is beyond it; undefined where it holds. */
  readonly beyond: (of: Measures, wanted: number) => string | undefined;
}

/** How far a size is from what it was to become, as a share of that. */
export const offSize = ({ ratio }: Kept, wanted = 1): number => Math.abs(ratio / wanted - 1);

/** By what radii are to change: balls and rings that are pulled at two points grow as a whole. */
export const wantedRatio = ({ grows = false }: Case, { factor }: Stretching): number => (grows ? factor : 1);

const isHole = ({ name }: Kept): boolean => /hole|bore/.test(name);
const mostOff = (kept: Kept): number => (isHole(kept) ? 0.02 : 0.03);
const offRound = ({ roundness = 0 }: Kept): number => roundness;

export const limits: readonly Limit[] = [
  {
    title: 'holes keep their size within 2 %, other round parts within 3 %',
    concerns: ({ rounds }) => rounds.length > 0,
    beyond: ({ rounds }, wanted) =>
      worst(
        rounds.filter((kept) => offSize(kept, wanted) > mostOff(kept)),
        (kept) => offSize(kept, wanted),
        ({ name, ratio }) => `${name} ×${ratio.toFixed(3)}`,
      ),
  },
  {
    title: 'round parts stay round within 0.006 of their radius',
    concerns: ({ rounds }) => rounds.length > 0,
    beyond: ({ rounds }) =>
      worst(
        rounds.filter((kept) => offRound(kept) > 0.006),
        offRound,
        (kept) => `${kept.name} off round by ${offRound(kept).toFixed(4)}`,
      ),
  },
  {
    title: 'bevels keep their width within 5 %',
    concerns: ({ bevels }) => bevels.length > 0,
    beyond: ({ bevels }) =>
      worst(
        bevels.filter((kept) => offSize(kept) > 0.05),
        (kept) => offSize(kept),
        ({ name, ratio }) => `${name} ×${ratio.toFixed(3)}`,
      ),
  },
  {
    title: 'flat sides tilt by at most 0.1°',
    beyond: ({ planeTilt }) => (planeTilt > 0.1 ? `a side tilts by ${planeTilt.toFixed(3)}°` : undefined),
  },
  {
    title: 'straight creases bend by at most 0.3 % of the diagonal',
    beyond: ({ lineBend }) =>
      lineBend > 0.003 ? `a crease bends by ${(100 * lineBend).toFixed(2)} %` : undefined,
  },
  {
    title: 'normals turn by at most 10°',
    beyond: ({ normalMax }) => (normalMax > 10 ? `a normal turns by ${normalMax.toFixed(0)}°` : undefined),
  },
  {
    title: 'handles are within 0.5 % of the diagonal of their targets',
    beyond: ({ handle }) =>
      handle > 0.005 ? `a handle is off by ${(100 * handle).toFixed(2)} %` : undefined,
  },
  {
    title: 'no face turns over',
    beyond: ({ flipped }) => (flipped > 0 ? `turned over: ${flipped}` : undefined),
  },
  {
    title: 'all but 1 % of the faces keep half of their quality',
    beyond: ({ quality }) =>
      quality < 0.5 ? `faces keep ${quality.toFixed(2)} of their quality` : undefined,
  },
];

/** What a person would notice of a result, a few words for each limit that it does not hold. */
export function shortfalls(of: Measures, wanted = 1): string[] {
  return limits.flatMap(({ beyond }) => beyond(of, wanted) ?? []);
}

function worst(
  offending: readonly Kept[],
  by: (kept: Kept) => number,
  words: (kept: Kept) => string,
): string | undefined {
  if (offending.length === 0) return undefined;
  const most = offending.reduce((a, b) => (by(b) > by(a) ? b : a));
  return words(most) + (offending.length > 1 ? ` (${offending.length} such)` : '');
}
