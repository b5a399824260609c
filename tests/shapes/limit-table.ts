import { markdownTable, median } from '../benchmarks/numbers.ts';
import { limits, shortfalls } from './limits.ts';
import type { Measures } from './measures.ts';

/** A gesture that was tried by one of several methods or on one of several meshes. */
export interface Measured {
  readonly shape: string;
  /** Name of the method or of the mesh. */
  readonly by: string;
  /** By what radii were to change. */
  readonly wanted: number;
  /** The sentence of the refusal where it was refused. */
  readonly result: Measures | string;
}

/** How many of the gestures hold each limit, a column for each method or mesh. */
export function limitTable(all: readonly Measured[]): string {
  const groups = grouped(all, ({ by }) => by);
  const count = (title: string, holds: (of: Measures, wanted: number) => boolean, concerns = anyShape) => [
    title,
    ...groups.map(([, trials]) => {
      // One that was refused holds nothing; what its shape has is told by its other gestures and methods.
      const asked = trials.filter(({ shape }) =>
        answered(all.filter((of) => of.shape === shape)).some(concerns),
      );
      const good = asked.filter(({ result, wanted }) => typeof result !== 'string' && holds(result, wanted));
      return `${good.length} of ${asked.length}`;
    }),
  ];
  const middle = (title: string, show: (result: Measures) => number): string[] => [
    title,
    ...groups.map(([, of]) => `${median(answered(of).map(show)).toFixed(2)}°`),
  ];
  return markdownTable(
    ['', ...groups.map(([by]) => by)],
    [
      count('not refused', () => true),
      ...limits.map(({ title, beyond, concerns }) =>
        count(title, (result, wanted) => beyond(result, wanted) === undefined, concerns),
      ),
      count('**all of it**', (result, wanted) => shortfalls(result, wanted).length === 0),
      middle('mean change of normals, the median gesture', ({ normalMean }) => normalMean),
      middle('largest change of normals, the median gesture', ({ normalMax }) => normalMax),
    ],
  );
}

const anyShape = (_: Measures): boolean => true;

/** Trials by a name of theirs, in the order in which the names come first. */
export function grouped<T>(trials: readonly T[], nameOf: (trial: T) => string): [string, T[]][] {
  const groups = new Map<string, T[]>();
  for (const trial of trials) groups.set(nameOf(trial), [...(groups.get(nameOf(trial)) ?? []), trial]);
  return [...groups];
}

const answered = (trials: readonly Measured[]): Measures[] =>
  trials.flatMap(({ result }) => (typeof result === 'string' ? [] : [result]));
