import { cpus, totalmem } from 'node:os';
import { duration, markdownTable, percent, times } from './numbers.ts';
import type { ComparedMethod } from './options.ts';
import { type Build, builds, type Descent, type Measurement } from './program.ts';

/** Iterations per second that the authors of Cubic Stylization report at about 20k vertices. */
const paperRate = 24;

export type Measurements = readonly Record<Build, Measurement>[];

export function describeMachine({ native, wasm }: Record<Build, { readonly compiler: string }>): string {
  const memory = Math.round(totalmem() / 2 ** 30);
  return `${cpus()[0]?.model.trim()}, ${memory} GB, one thread; Node ${process.version}, native by ${native.compiler}, wasm by ${wasm.compiler}.`;
}

const problems: Readonly<Record<ComparedMethod, string>> = {
  cubic: 'cubic, λ 0.4',
  analogy: 'analogy, the style of a cube, constant targets, λ 1',
  arap: 'arap, both ends held, one of them turned by 60°',
};

/** The tables of one method. */
export function report(method: ComparedMethod, measurements: Measurements): string {
  const sections = [
    `## ${problems[method]}`,
    phases(measurements),
    descents(measurements),
    between(measurements),
  ];
  const bunny = measurements.find(({ wasm }) => wasm.vertices === 22046);
  if (method === 'cubic' && bunny) sections.push(bunnySection(bunny));
  return sections.join('\n\n');
}

function rowsOf(
  measurements: Measurements,
  cells: (measurement: Measurement) => readonly string[],
): string[][] {
  return measurements.flatMap((both) =>
    builds.map((build) => [String(both[build].vertices), build, ...cells(both[build])]),
  );
}

function phases(measurements: Measurements): string {
  const rows = rowsOf(measurements, ({ phases: { prepare, iteration } }) => [
    ...[prepare.order, prepare.factor, prepare.whole].map(({ ratio }) => times(ratio)),
    ...[iteration.rest, iteration.solve, iteration.whole].map(({ ratio }) => times(ratio)),
    (1000 / iteration.whole.ours).toFixed(0),
    (1000 / iteration.whole.plain).toFixed(0),
  ]);
  return `Times as fast as the plain Eigen path (medians by turns in one process; “local” is all of an iteration but the solve):

${markdownTable(['vertices', 'build', 'order', 'factor', 'prepare', 'local', 'solve', 'iteration', 'it/s', 'plain it/s'], rows)}`;
}

const atStop = ({ stop, iterations }: Descent): string =>
  stop.iterations < 0 ? `not in ${iterations}` : `${stop.iterations}, +${percent(stop.aboveLowest)}`;

/** Where the energy did not come to rest, E* is only the lowest that was seen. */
const about = (cold: Descent): string => (cold.rested ? '' : '≈ ');

/** Only of a run that came to rest is it known that it never gets there. */
function reached(run: Descent, iterations: number): string {
  if (iterations >= 0) return String(iterations);
  return run.rested ? 'never' : `> ${run.iterations}`;
}

/** When the reference was within 0.1 %, or when its time was up before; true if it got there. */
function plainToPermille({ toPermille, time }: Descent): [number, boolean] {
  return toPermille.time >= 0 ? [toPermille.time, true] : [time, false];
}

function descents(measurements: Measurements): string {
  const rows = rowsOf(measurements, ({ cold, plain, warm, memory, vertices }) => [
    `${about(cold)}${reached(cold, cold.toPercent.iterations)} / ${reached(cold, cold.toPermille.iterations)}`,
    atStop(cold),
    `${about(cold)}${duration(cold.toPermille.time)}`,
    duration(warm.toPermille.time),
    `${reached(plain, plain.toPercent.iterations)} / ${reached(plain, plain.toPermille.iterations)}`,
    atStop(plain),
    duration(plain.stop.time),
    `${plainToPermille(plain)[1] ? '' : '> '}${duration(plainToPermille(plain)[0])}`,
    `${(memory / 2 ** 20).toFixed(0)} MB, ${(memory / 1024 / vertices).toFixed(2)} KB`,
    `${cold.iterations}${cold.rested ? '' : ' (time was up)'}`,
  ]);
  const headers = [
    'vertices',
    'build',
    'its to 1 / 0.1 %',
    'at the stop',
    'to 0.1 %, fresh',
    'warm',
    'plain: 1 / 0.1 %',
    'plain: at its stop',
    'plain: time to it',
    'plain: time to 0.1 %',
    'memory, a vertex',
    'E* after',
  ];
  return `Iterations to within 1 % and 0.1 % of the converged energy E*; iterations and energy above E* at the papers’ stop (relative displacement 3e-3); times
from the loaded mesh, preparing included, in a fresh process and later; most memory until then. Where time was up before the energy came to
rest, E* is the lowest seen and iterations to it are marked ≈:

${markdownTable(headers, rows)}`;
}

function between(measurements: Measurements): string {
  const rows = measurements.map(({ native, wasm }) => {
    const rate = 1000 / wasm.phases.iteration.whole.ours;
    return [
      String(wasm.vertices),
      (wasm.phases.prepare.whole.ours / native.phases.prepare.whole.ours).toFixed(2),
      (wasm.phases.iteration.whole.ours / native.phases.iteration.whole.ours).toFixed(2),
      `${rate.toFixed(0)} (${times(rate / paperRate)} the paper’s ${paperRate} at about 20k)`,
      Math.abs(wasm.energyAtFixedCount / native.energyAtFixedCount - 1).toExponential(1),
    ];
  });
  const headers = ['vertices', 'prepare', 'iteration', 'iterations/s, wasm', 'energies apart'];
  return `Wasm over native, of two processes after each other, and how far their energies are apart after 20 iterations:

${markdownTable(headers, rows)}`;
}

/** What the core was built to reach at 22046 vertices as wasm: times as fast as the plain path, at least. */
export function bars({ cold, plain, phases: { prepare, iteration } }: Measurement): string {
  const [plainTime, isThere] = plainToPermille(plain);
  const rows: [string, number, number, string?][] = [
    ['local', 10, iteration.rest.ratio],
    ['solve', 4, iteration.solve.ratio],
    ['iteration', 10, iteration.whole.ratio],
    ['factor', 2, prepare.factor.ratio],
    ['from the mesh to within 0.1 % of E*', 20, plainTime / cold.toPermille.time, isThere ? '' : '> '],
  ];
  const cells = rows.map(([what, bar, measured, sign = '']) => [
    what,
    `${bar}×`,
    `${sign}${times(measured)}`,
    measured >= bar ? 'yes' : 'no',
  ]);
  return `Bars, as wasm:\n\n${markdownTable(['what', 'bar', 'measured', 'met'], cells)}`;
}

/** The time that matters to a person, on the mesh that the papers show. */
function bunnySection({ native, wasm }: Record<Build, Measurement>): string {
  const line = (build: Build, { cold, plain }: Measurement): string =>
    `- ${build}: from the loaded mesh to within 0.1 % of E* in ${duration(cold.toPermille.time)}, in a fresh process; the plain path needs ${times(plain.stop.time / cold.toPermille.time)} as long to its own stop, ${percent(plain.stop.aboveLowest)} above E*.`;
  return `### The bunny of 22046 vertices

${line('wasm', wasm)}
${line('native', native)}

The authors’ own program takes 8.8 s to its stop (measured elsewhere, not in this run).

${bars(wasm)}`;
}
