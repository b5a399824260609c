import { duration, markdownTable, median, times } from './numbers.ts';
import { type Build, builds, type GestureRun, type Reshaping } from './program.ts';

export type Reshapings = readonly Record<Build, Reshaping>[];

/** The tables of reshaping. */
export function reportReshaping(reshapings: Reshapings): string {
  return [
    '## reshape, gestures on generated shapes',
    runs(reshapings),
    plain(reshapings),
    solvers(reshapings),
    bars(reshapings),
  ]
    .filter((section) => section !== '')
    .join('\n\n');
}

const finals = ({ runs: all }: Reshaping): number[] => all.map(({ final }) => final);
const largest = (all: readonly GestureRun[], time: 'first' | 'final'): number =>
  Math.max(...all.map((run) => run[time]));

function rowsOf(reshapings: Reshapings, cells: (reshaping: Reshaping) => readonly string[][]): string[][] {
  return reshapings.flatMap((both) =>
    builds.flatMap((build) =>
      cells(both[build]).map((row) => [String(both[build].cold.faces), build, ...row]),
    ),
  );
}

function runs(reshapings: Reshapings): string {
  const gestures = rowsOf(reshapings, ({ runs: all }) =>
    all.map(({ name, ready, first, final, iterations }) => [
      name,
      duration(ready),
      duration(first),
      duration(final),
      String(iterations),
      duration((final - ready) / iterations),
    ]),
  );
  const totals = rowsOf(reshapings, (reshaping) => [
    [
      duration(reshaping.cold.final),
      duration(median(finals(reshaping))),
      duration(largest(reshaping.runs, 'final')),
      duration(largest(reshaping.runs, 'first')),
      `${(reshaping.memory / 2 ** 20).toFixed(0)} MB, ${(reshaping.memory / 1024 / reshaping.cold.faces).toFixed(2)} KB`,
    ],
  ]);
  const headers = [
    'faces',
    'build',
    'the first, fresh',
    'median',
    'worst',
    'first picture, worst',
    'memory, a face',
  ];
  return `As it comes (“tuned”), to the final result with everything that belongs to it; times from the loaded mesh. A plate with five holes, a cylinder,
a bracket, a ball, all of about as many faces. Memory until the end of the first gesture, in a fresh process:

${markdownTable(headers, totals)}

${markdownTable(['faces', 'build', 'gesture', 'ready', 'first picture', 'final', 'iterations', 'each'], gestures)}`;
}

function plain(reshapings: Reshapings): string {
  const rows = rowsOf(reshapings, ({ compared }) => {
    if (!compared) return [];
    const { iteration, plainIterations, plainTime, plainFinished } = compared;
    return [
      [
        duration(iteration.ours),
        duration(iteration.plain),
        times(iteration.ratio),
        `${plainIterations} in ${duration(plainTime)}${plainFinished ? '' : ' (time was up)'}`,
      ],
    ];
  });
  if (rows.length === 0) return '';
  return `The plate lengthened as printed, core and plain Eigen by turns in one process. The plain one factors both matrices in every iteration and analyzes them
once; beyond 30000 faces its factor takes minutes and gigabytes and is left out:

${markdownTable(['faces', 'build', 'an iteration', 'plain', 'ratio', 'plain run'], rows)}`;
}

function solvers(reshapings: Reshapings): string {
  const rows = rowsOf(reshapings, ({ solvers: all }) => {
    if (!all) return [];
    const ways = [all.direct, all.gradients, all.blocks, all.means];
    return [ways.flatMap(({ prepare, solve }) => [duration(prepare), duration(solve)])];
  });
  if (rows.length === 0) return '';
  const headers = [
    'direct: once',
    'each',
    'gradients: once',
    'each',
    'blocks of 3: once',
    'each',
    'mean: once',
    'each',
  ];
  return `Ways to solve the two systems, once for a mesh and handles and then in each iteration. Transformations: our own factor in blocks of 9, or conjugate
gradients (what the core does). Vertices: the factor of the first matrix in blocks of 3, or of the mean of its axes (what the core does), as preconditioner:

${markdownTable(['faces', 'build', ...headers], rows)}`;
}

/** What reshaping was built to reach as wasm. */
export function bars(reshapings: Reshapings): string {
  const at = (faces: number) =>
    reshapings.find(({ wasm }) => Math.abs(wasm.cold.faces / faces - 1) < 0.2)?.wasm;
  const [middle, large] = [at(8500), at(84_000)];
  const rows: [string, number, number][] = [];
  if (middle) {
    rows.push(['about 8.5K faces, median to the final result', 800, median(finals(middle))]);
    rows.push(['about 8.5K faces, worst', 2500, largest(middle.runs, 'final')]);
  }
  if (large) {
    rows.push(['about 84K faces, worst', 25_000, largest(large.runs, 'final')]);
    rows.push(['about 84K faces, first picture, worst', 2000, largest(large.runs, 'first')]);
  }
  if (rows.length === 0) return '';
  const cells = rows.map(([what, bar, measured]) => [
    what,
    `≤ ${duration(bar)}`,
    duration(measured),
    measured <= bar ? 'yes' : 'no',
  ]);
  return `Bars, as wasm:\n\n${markdownTable(['what', 'bar', 'measured', 'met'], cells)}`;
}
