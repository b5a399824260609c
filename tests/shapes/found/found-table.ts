import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { duration, markdownTable, percent } from '../../benchmarks/numbers.ts';
import { objText } from '../../fixtures/mesh-files.ts';
import { asDrawn, caseOf, meshed } from '../cases.ts';
import type { Stretching } from '../gestures.ts';
import { keepTables } from '../kept-tables.ts';
import { grouped, limitTable } from '../limit-table.ts';
import { offSize } from '../limits.ts';
import type { Kept } from '../measures.ts';
import type { Shape } from '../shape.ts';
import { methods } from '../trials.ts';
import { foundGestures } from './found-gestures.ts';
import { foundShape, type Thing } from './found-shape.ts';
import { type FoundResult, type FoundTrial, foundTrials } from './found-trials.ts';

/** Our own, as programs for construction write them but for the mug, which is made of even faces only. */
const own = ['chair', 'bracket', 'nut', 'bolt', 'mug'].map(caseOf);

/**
 * Reshapes what people made: the mesh files in a folder that a list of {@link Thing}s names, and our own shapes.
 *
 * `--things=list.json` is another list than that of the package metaworld, `--out=folder` keeps every shape before and after as OBJ,
 * `--write` keeps the tables in docs/reshaping.md, a word picks by name. @param args the folder first
 */
export async function tabulateFound(args: readonly string[]): Promise<void> {
  const [folder, word = ''] = args.filter((arg) => !arg.startsWith('--'));
  const option = (name: string) => args.find((arg) => arg.startsWith(`--${name}=`))?.slice(name.length + 3);
  if (!folder)
    throw new Error(
      'Which folder? npm run reshape:found -- FOLDER [--things=LIST] [--out=FOLDER] [--write] [WORD]',
    );
  const list = option('things') ?? new URL('./metaworld.json', import.meta.url);
  const things = (JSON.parse(readFileSync(list, 'utf8')) as Thing[]).filter(({ name }) =>
    name.includes(word),
  );
  const trials: FoundTrial[] = [];
  const run = async (shape: Shape, gestures: Readonly<Record<string, Stretching>>) => {
    console.error(`${shape.name} …`);
    const made = await foundTrials(shape, gestures, methods);
    trials.push(...made);
    const out = option('out');
    if (out) keepShapes(out, shape, made);
  };
  for (const thing of things) {
    const shape = foundShape(folder, thing);
    await run(shape, thing.gestures ?? foundGestures(shape));
  }
  const tables = { 'found files': filesTable(folder, things) };
  for (const made of option('things') ? [] : own.filter(({ name }) => name.includes(word)))
    await run(
      { ...(made.isDrawn ? asDrawn(made) : meshed(made, 2)), name: `our ${made.name}` },
      made.gestures,
    );
  Object.assign(tables, {
    'found methods': methodTable(trials),
    found: gestureTable(trials.filter(({ by }) => by === 'tuned')),
  });
  const all = gestureTable(trials, true);
  for (const [name, table] of Object.entries({ ...tables, all })) console.log(`\n${name}\n\n${table}`);
  if (args.includes('--write')) keepTables(tables);
}

function keepShapes(out: string, shape: Shape, trials: readonly FoundTrial[]): void {
  writeFileSync(join(out, `${shape.name}.obj`), objText(shape));
  for (const { gesture, by, result } of trials)
    if (typeof result !== 'string') {
      const name = `${shape.name}, ${gesture.replace(/ ×.*/, '')}, ${by}.obj`;
      writeFileSync(join(out, name), objText({ ...shape, positions: result.run.positions }));
    }
}

const filesTable = (folder: string, things: readonly Thing[]): string =>
  markdownTable(
    ['thing', 'file', 'SHA-256, its first half'],
    things.flatMap(({ name, files }) =>
      files.map((file) => {
        const path = typeof file === 'string' ? file : file.path;
        const hash = createHash('sha256')
          .update(readFileSync(join(folder, path)))
          .digest('hex');
        return [name, `\`${path}\``, `\`${hash.slice(0, 32)}\``];
      }),
    ),
  );

/** What holds the limits, by method: a gesture is asked for what it does not change by itself. */
const methodTable = (trials: readonly FoundTrial[]): string =>
  limitTable(trials.map((trial) => ({ ...trial, shape: `${trial.shape}, ${trial.gesture}`, wanted: 1 })));

const columns: Readonly<Record<string, (of: FoundResult) => string>> = {
  'normals, mean': ({ normalMean }) => `${normalMean.toFixed(2)}°`,
  'normals, most': ({ normalMax }) => `${normalMax.toFixed(1)}°`,
  radius: ({ rounds }) => farthestRatio(rounds),
  'off round': ({ rounds }) => most(rounds.map(({ roundness = 0 }) => roundness)),
  bevels: ({ bevels }) => farthestRatio(bevels),
  thickness: ({ thickness }) => percent(Number(thickness.toFixed(4))),
  'handles off': ({ handle }) => percent(Number(handle.toFixed(5))),
  'turned over': ({ flipped }) => String(flipped),
  time: ({ run }) => duration(run.time),
  'it says': ({ run }) => said(run.warnings) || '–',
};

function gestureTable(trials: readonly FoundTrial[], withMethod = false): string {
  const rows = grouped(trials, ({ shape, gesture }) => `${shape} ${gesture}`).flatMap(([, of]) =>
    of.map(({ shape, faces, gesture, by, result }) => [
      shape,
      String(faces),
      gesture,
      ...(withMethod ? [by] : []),
      ...Object.values(columns).map((show) => (typeof result === 'string' ? 'refused' : show(result))),
    ]),
  );
  const titles = ['thing', 'faces', 'gesture', ...(withMethod ? ['method'] : []), ...Object.keys(columns)];
  return markdownTable(titles, rows);
}

/** What the program says of the result, in a word each; how it went about it is not of it. */
function said(warnings: readonly string[]): string {
  const words: readonly [RegExp, string][] = [
    [/change(s their|s its| their) size/, 'sizes change'],
    [/as thick/, 'walls change'],
    [/Of the faces/, 'faces turn over'],
    [/own thin faces/, 'thin faces turn over'],
    [/handle is missed/, 'a handle is missed'],
    [/no direction/, 'thin faces'],
  ];
  return words
    .flatMap(([pattern, word]) => (warnings.some((text) => pattern.test(text)) ? [word] : []))
    .join(', ');
}

function farthestRatio(parts: readonly Kept[]): string {
  if (parts.length === 0) return '–';
  return parts.reduce((a, b) => (offSize(b) > offSize(a) ? b : a)).ratio.toFixed(3);
}

const most = (values: readonly number[]): string =>
  values.length === 0 ? '–' : Math.max(...values).toFixed(4);
