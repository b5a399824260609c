import { readFileSync, writeFileSync } from 'node:fs';
import { markdownTable, median, percent } from '../benchmarks/numbers.ts';
import { type Case, cases } from './cases.ts';
import { collapseTable } from './collapses.ts';
import { limits, offSize, shortfalls } from './limits.ts';
import type { Kept } from './measures.ts';
import { samenessTable } from './sameness.ts';
import { byMesh, byMethod, type Judged, type Trial } from './trials.ts';

const file = 'docs/reshaping.md';

/**
 * All shapes and gestures; `--write` keeps the tables in docs/reshaping.md, `--only=collapses` makes that table alone (or
 * `sameness`), a word picks shapes by their names.
 */
export async function tabulate(args: readonly string[]): Promise<void> {
  const word = args.find((arg) => !arg.startsWith('--')) ?? '';
  const only = args.find((arg) => arg.startsWith('--only='))?.slice('--only='.length);
  const chosen = cases.filter(({ name }) => name.includes(word));
  const tables: Record<string, string> = {};
  if (!only) Object.assign(tables, await trialTables(chosen));
  if (!only || only === 'sameness') tables.sameness = await samenessTable(chosen);
  if (!only || only === 'collapses') tables.collapses = await collapseTable(chosen);
  for (const [name, table] of Object.entries(tables)) console.log(`\n${name}\n\n${table}`);
  if (args.includes('--write')) writeFileSync(file, replaced(readFileSync(file, 'utf8'), tables));
}

/** The tables that go by the limits and measures of every gesture. */
async function trialTables(chosen: readonly Case[]): Promise<Record<string, string>> {
  const methods: Trial[] = [];
  const meshes: Trial[] = [];
  for (const made of chosen) {
    console.error(`${made.name} …`);
    methods.push(...(await byMethod(made)));
    meshes.push(...(await byMesh(made)));
  }
  return {
    methods: limitTable(methods),
    meshes: limitTable(meshes),
    shortfalls: shortfallTable(meshes),
    walls: wallTable(meshes),
    unrest: unrestTable(meshes),
    gestures: gestureTable(methods),
  };
}

/** The text with each table between its two marks. */
function replaced(text: string, tables: Readonly<Record<string, string>>): string {
  return Object.entries(tables).reduce((whole, [name, table]) => {
    const [begin, end] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
    const [before, rest] = whole.split(begin);
    const after = rest?.split(end)[1];
    if (after === undefined) throw new Error(`${file} has no ${begin} … ${end}.`);
    return `${before}${begin}\n\n${table}\n\n${end}${after}`;
  }, text);
}

/** How many of the gestures hold each limit, a column for each method or mesh. */
function limitTable(all: readonly Trial[]): string {
  const groups = grouped(all, ({ by }) => by);
  const count = (title: string, holds: (of: Judged, wanted: number) => boolean, concerns = anyShape) => [
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
  const middle = (title: string, show: (result: Judged) => number): string[] => [
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

const anyShape = (_: Judged): boolean => true;

/** Trials by a name of theirs, in the order in which the names come first. */
function grouped(trials: readonly Trial[], nameOf: (trial: Trial) => string): [string, Trial[]][] {
  const groups = new Map<string, Trial[]>();
  for (const trial of trials) groups.set(nameOf(trial), [...(groups.get(nameOf(trial)) ?? []), trial]);
  return [...groups];
}

const answered = (trials: readonly Trial[]): Judged[] =>
  trials.flatMap(({ result }) => (typeof result === 'string' ? [] : [result]));

/** What falls short on some mesh, and by what. */
function shortfallTable(trials: readonly Trial[]): string {
  const rows = trials.flatMap(({ shape, gesture, by, wanted, result }) => {
    const words = typeof result === 'string' ? ['refused'] : shortfalls(result, wanted);
    return words.length === 0 ? [] : [[shape, gesture, by, words.join(', ')]];
  });
  return markdownTable(['shape', 'gesture', 'mesh', 'what is beyond its limit, the worst of each'], rows);
}

/** Where walls change their thickness by more than 5 %. */
function wallTable(trials: readonly Trial[]): string {
  const rows = trials.flatMap(({ shape, gesture, by, result }) => {
    if (typeof result === 'string' || result.thickness <= 0.05) return [];
    return [[shape, gesture, by, percent(Number(result.thickness.toFixed(3)))]];
  });
  return markdownTable(['shape', 'gesture', 'mesh', 'thickness changes by'], rows);
}

/** The runs whose last fifth moves something by more than 0.2 % of the diagonal. */
function unrestTable(trials: readonly Trial[]): string {
  const rows = trials.flatMap(({ shape, gesture, by, result }) => {
    if (typeof result === 'string' || result.late.anyway <= 0.002) return [];
    const { anyway, outOfFaces } = result.late;
    return [[shape, gesture, by, String(result.run.iterations), exactly(outOfFaces), exactly(anyway)]];
  });
  const titles = ['shape', 'gesture', 'mesh', 'iterations', 'out of its face', 'anyway'];
  return `${rows.length} of ${trials.length} runs:\n\n${markdownTable(titles, rows)}`;
}

/** Every gesture by every method, in numbers. */
function gestureTable(trials: readonly Trial[]): string {
  return grouped(trials, ({ shape }) => shape)
    .map(([shape, of]) => `### ${shape}\n\n${tableOf(of)}`)
    .join('\n\n');
}

const columns: Readonly<Record<string, (of: Judged, wanted: number) => string>> = {
  'normals, mean': ({ normalMean }) => `${normalMean.toFixed(2)}°`,
  'normals, most': ({ normalMax }) => `${normalMax.toFixed(1)}°`,
  radius: ({ rounds }, wanted) => farthestRatio(rounds, wanted),
  'off round': ({ rounds }) =>
    rounds.length === 0 ? '–' : Math.max(...rounds.map(({ roundness = 0 }) => roundness)).toFixed(4),
  bevels: ({ bevels }) => farthestRatio(bevels, 1),
  thickness: ({ thickness }) => percent(Number(thickness.toFixed(4))),
  tilt: ({ planeTilt }) => `${planeTilt.toFixed(2)}°`,
  'handles off': ({ handle }) => exactly(handle),
  'turned over': ({ flipped }) => String(flipped),
  iterations: ({ run }) => String(run.iterations),
};

function tableOf(trials: readonly Trial[]): string {
  // What a shape does not have takes no column.
  const shown = Object.entries(columns).filter(([, show]) =>
    trials.some(({ result, wanted }) => typeof result !== 'string' && show(result, wanted) !== '–'),
  );
  const rows = trials
    .toSorted((a, b) => order(trials, a) - order(trials, b))
    .map(({ gesture, by, wanted, result }) => [
      gesture,
      by,
      ...shown.map(([, show]) => (typeof result === 'string' ? 'refused' : show(result, wanted))),
    ]);
  return markdownTable(['gesture', 'method', ...shown.map(([title]) => title)], rows);
}

/** Gestures one after the other, each with its methods in their order. */
const order = (trials: readonly Trial[], { gesture }: Trial): number =>
  trials.findIndex((other) => other.gesture === gesture);

function farthestRatio(parts: readonly Kept[], wanted: number): string {
  if (parts.length === 0) return '–';
  return parts.reduce((a, b) => (offSize(b, wanted) > offSize(a, wanted) ? b : a)).ratio.toFixed(3);
}

const exactly = (share: number): string => percent(Number(share.toFixed(5)));
