import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bunnyLevel, icosphere, type TestMesh } from '../fixtures/meshes.ts';
import type { ComparedMethod, FaceCount, MethodId, Size, TimedMethod } from './options.ts';

export const builds = ['native', 'wasm'] as const;
export type Build = (typeof builds)[number];

/** Iterations and time (ms, from the loaded mesh) to a point of a run; both −1 where it was never reached. */
export interface Milestone {
  readonly iterations: number;
  readonly time: number;
}

/** A run of the core or of the reference, energies as shares above the lowest seen. */
export interface Descent extends Milestone {
  readonly rested: number;
  readonly aboveLowest: number;
  readonly toPercent: Milestone;
  readonly toPermille: Milestone;
  readonly stop: Milestone & { readonly aboveLowest: number };
}

/** A phase of the core and of the reference, ms, and how many times as fast the core is. */
export interface Comparison {
  readonly ours: number;
  readonly plain: number;
  readonly ratio: number;
}

/** What `whittle-bench` prints of a method without a plain path; times in ms, memory in bytes. */
export interface Timing {
  readonly vertices: number;
  readonly compiler: string;
  readonly memory: number;
  readonly alone: {
    /** From the loaded mesh to ready, in a fresh process and later. */
    readonly fresh: number;
    readonly warm: number;
    readonly iteration: number;
    /** How many the run took, to its end if `finished` (1). */
    readonly iterations: number;
    readonly finished: number;
    readonly time: number;
    readonly firstEnergy: number;
    readonly lastEnergy: number;
    readonly energyAtFixedCount: number;
  };
}

/** What `whittle-bench` prints; times in ms, memory in bytes. */
export interface Measurement {
  readonly vertices: number;
  readonly compiler: string;
  readonly memory: number;
  readonly lowest: number;
  readonly energyAtFixedCount: number;
  readonly cold: Descent;
  readonly warm: Descent;
  readonly plain: Descent;
  readonly phases: {
    readonly prepare: { readonly whole: Comparison; readonly order: Comparison; readonly factor: Comparison };
    /** `solve`: three right-hand sides through the factor; `rest`: all the others. */
    readonly iteration: { readonly whole: Comparison; readonly solve: Comparison; readonly rest: Comparison };
  };
}

/** A run of a gesture, ms from the loaded mesh in a session of its own. */
export interface GestureRun {
  readonly name: string;
  readonly faces: number;
  readonly ready: number;
  readonly first: number;
  readonly final: number;
  readonly iterations: number;
}

/** What a way to solve a system takes: once, and in an iteration. */
export interface SolverTimes {
  readonly prepare: number;
  readonly solve: number;
}

/** What `whittle-bench reshape` prints; times in ms, memory in bytes. */
export interface Reshaping {
  readonly compiler: string;
  /** The first gesture in a fresh process, and the most memory until its end. */
  readonly cold: GestureRun;
  readonly memory: number;
  readonly runs: readonly GestureRun[];
  /** On the first gesture as printed; not where it would take minutes. */
  readonly compared?: {
    readonly iteration: Comparison;
    readonly plainIterations: number;
    readonly plainTime: number;
    readonly plainFinished: number;
  };
  readonly solvers?: {
    readonly direct: SolverTimes;
    readonly gradients: SolverTimes;
    readonly blocks: SolverTimes & { readonly iterations: number };
    readonly means: SolverTimes;
  };
}

/** The largest mesh gets more time, and still only some iterations of the reference. */
const seconds = (size: Size): number => (size > 100_000 ? 7 : 6);

export function meshOf(size: Size): TestMesh {
  if (size === 22046) return bunnyLevel(2);
  return icosphere(Math.round(Math.log((size - 2) / 10) / Math.log(4)));
}

type Printed = Measurement | Timing | Reshaping;

/** Runs the benchmark program on gestures, each build in a process of its own. */
export function measureReshaping(faces: FaceCount): Record<Build, Reshaping> {
  return runBuilds(['reshape', String(faces), '30']) as Record<Build, Reshaping>;
}

/** Runs the benchmark program on one mesh, each build in a process of its own. */
export function measure(method: ComparedMethod, size: Size): Record<Build, Measurement>;
export function measure(method: TimedMethod, size: Size): Record<Build, Timing>;
export function measure(method: MethodId, size: Size): Record<Build, Measurement | Timing> {
  const folder = mkdtempSync(join(tmpdir(), 'whittle-bench-'));
  try {
    const file = join(folder, 'mesh');
    const mesh = meshOf(size);
    const counts = Int32Array.of(mesh.positions.length / 3, mesh.triangles.length / 3);
    const parts = [counts, mesh.positions, mesh.triangles];
    writeFileSync(file, Buffer.concat(parts.map((array) => Buffer.from(array.buffer))));
    return runBuilds([method, file, String(seconds(size))]) as Record<Build, Measurement | Timing>;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function runBuilds(args: readonly string[]): Record<Build, Printed> {
  return {
    native: run('wasm/build/native-bench/bench/whittle-bench', args),
    wasm: run(process.execPath, ['wasm/build/wasm-bench/bench/whittle-bench.cjs', ...args]),
  };
}

function run(program: string, args: readonly string[]): Printed {
  const { status, stdout, stderr, error } = spawnSync(program, args, { encoding: 'utf8' });
  if (status === 0) return JSON.parse(stdout) as Printed;
  // Uncaught, Emscripten's loader prints all of itself first.
  const reason = error?.message ?? stderr.trim().slice(-600);
  throw new Error(`${program} ${args.join(' ')} failed: ${reason}`);
}
