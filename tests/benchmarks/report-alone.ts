import { duration, markdownTable } from './numbers.ts';
import type { TimedMethod } from './options.ts';
import { type Build, builds, type Timing } from './program.ts';

const problems: Readonly<Record<TimedMethod, string>> = {
  normalmap: 'normalmap, waves, λ 10, acap',
  developable: 'developable, as it comes',
  polycube: 'polycube, the directions of a cube; every iteration factors anew',
};

/** The table of a method that has no plain path. */
export function reportAlone(method: TimedMethod, timings: readonly Record<Build, Timing>[]): string {
  const rows = timings.flatMap((both) => builds.map((build) => row(build, both)));
  const headers = [
    'vertices',
    'build',
    'ready, fresh',
    'warm',
    'an iteration',
    'it/s',
    'run',
    'energy, first → last',
    'memory, a vertex',
    'wasm over native',
    'energies apart',
  ];
  return `## ${problems[method]}

From the loaded mesh to ready, in a fresh process and later; iterations, medians; a run to its end or until time was up. “Wasm over native” is of an iteration,
“energies apart” after 20 iterations.

${markdownTable(headers, rows)}`;
}

function row(build: Build, both: Record<Build, Timing>): string[] {
  const { vertices, memory, alone } = both[build];
  const end = alone.finished ? '' : ' (time was up)';
  return [
    String(vertices),
    build,
    duration(alone.fresh),
    duration(alone.warm),
    duration(alone.iteration),
    (1000 / alone.iteration).toFixed(0),
    `${alone.iterations} in ${duration(alone.time)}${end}`,
    `${alone.firstEnergy.toPrecision(4)} → ${alone.lastEnergy.toPrecision(4)}`,
    `${(memory / 2 ** 20).toFixed(0)} MB, ${(memory / 1024 / vertices).toFixed(2)} KB`,
    ...(build === 'wasm' ? comparison(both) : ['', '']),
  ];
}

function comparison({ native, wasm }: Record<Build, Timing>): string[] {
  const apart = Math.abs(wasm.alone.energyAtFixedCount / native.alone.energyAtFixedCount - 1);
  return [(wasm.alone.iteration / native.alone.iteration).toFixed(2), apart.toExponential(1)];
}
