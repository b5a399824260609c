import { markdownTable, percent } from '../benchmarks/numbers.ts';
import { type Case, cases } from './cases.ts';
import { collapseTable } from './collapses.ts';
import { keepTables } from './kept-tables.ts';
import { grouped, limitTable } from './limit-table.ts';
import { offSize, shortfalls } from './limits.ts';
import type { Kept } from './measures.ts';
import { samenessTable } from './sameness.ts';
import { byMesh, byMethod, type Judged, type Trial } from './trials.ts';

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
  if (args.includes('--write')) keepTables(tables);
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
