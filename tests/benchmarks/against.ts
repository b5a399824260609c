import { readFileSync } from 'node:fs';
import { createServer } from 'vite';
import type { Core, CoreSession } from '../../src/engine/core-api.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { configure, testCore } from '../fixtures/core.ts';
import type { TestMesh } from '../fixtures/meshes.ts';
import { markdownTable, percent, withSpread } from './numbers.ts';
import { type ComparedMethod, isCompared, type Options, type Size } from './options.ts';
import { meshOf } from './program.ts';
import { buildCore, withCheckout } from './reference.ts';

const rounds = 15;
const stepsARound = 6;
const warmUp = 3;
const runsToStop = 3;

interface Side {
  readonly core: Core;
  readonly prepares: number[];
  readonly iterations: number[];
}

/** Times the wasm module of the working tree against that of a git reference, by turns in this very process. */
export async function benchmarkAgainst(reference: string, options: Options): Promise<void> {
  await withCheckout(reference, async (folder, commit) => {
    buildCore(folder, reference);
    const base = await loadBase(folder, reference);
    const head = await testCore();
    const rows: string[][] = [];
    for (const method of options.methods.filter(isCompared)) {
      for (const size of options.sizes) {
        console.error(`${method}, ${size} vertices …`);
        rows.push([method, String(size), ...compare(base, head, method, size, reference)]);
      }
    }
    const headers = [
      'method',
      'vertices',
      'prepare',
      'iteration',
      'to the stop',
      'its base → head',
      'energy',
    ];
    console.log(`Working tree over ${reference} (${commit}), wasm: below 1 the working tree is faster. Medians of ${rounds} rounds by turns, quartiles in
brackets; “to the stop” is ${runsToStop} runs each from the loaded mesh, “energy” what the working tree’s end is above the other’s.

${markdownTable(headers, rows)}`);
  });
}

/** The core of another state of the repository, through its own TypeScript. */
async function loadBase(folder: string, reference: string): Promise<Core> {
  const server = await createServer({
    root: folder,
    configFile: false,
    appType: 'custom',
    logLevel: 'silent',
    server: { middlewareMode: true, hmr: false, ws: false },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    const { loadCore } = await server.ssrLoadModule('/src/engine/core.ts');
    return await loadCore(readFileSync(`${folder}/wasm/dist/whittle-core.wasm`));
  } catch (cause) {
    throw differs(reference, cause);
  } finally {
    await server.close();
  }
}

const differs = (reference: string, cause: unknown): Error =>
  new Error(`The core of ${reference} cannot be driven as today’s is: ${(cause as Error).message}`);

function compare(base: Core, head: Core, method: ComparedMethod, size: Size, reference: string): string[] {
  const mesh = meshOf(size);
  const parameters = problemOf(method, mesh);
  const knows = (core: Core): boolean => core.methods().some(({ id }) => id === method);
  if (!knows(base)) return [`${reference} has no ${method}`, '', '', '', ''];
  try {
    const sides = [base, head].map((core): Side => ({ core, prepares: [], iterations: [] }));
    timeByTurns(sides, mesh, method, parameters);
    const runs = Array.from({ length: runsToStop }, () =>
      [base, head].map((core) => runToStop(core, mesh, method, parameters)),
    );
    const [was, is] = runs[0]!;
    const ratios = (key: 'prepares' | 'iterations'): string =>
      withSpread(sides[1]![key].map((time, round) => time / sides[0]![key][round]!));
    const energy = is!.energy / was!.energy - 1;
    return [
      ratios('prepares'),
      ratios('iterations'),
      withSpread(runs.map(([before, after]) => after!.time / before!.time)),
      `${was!.iterations} → ${is!.iterations}`,
      `${energy < 0 ? '−' : '+'}${percent(Math.abs(energy))}`,
    ];
  } catch (cause) {
    throw differs(reference, cause);
  }
}

function problemOf(method: ComparedMethod, mesh: TestMesh): ParameterValues {
  if (method === 'cubic') return { lambda: 0.4 };
  if (method === 'arap') return { handles: turnedEnd(mesh) };
  return { lambda: 1, style: { kind: 'closest', normals: findPrimitive('cube')!.normals } };
}

/** The lowest tenth along y stays, the highest turns by 60° about y. */
function turnedEnd({ positions }: TestMesh): { vertices: number[]; targets: [number, number, number][] } {
  const heights = Array.from({ length: positions.length / 3 }, (_, v) => positions[3 * v + 1]!);
  const low = heights.reduce((a, b) => Math.min(a, b));
  const extent = heights.reduce((a, b) => Math.max(a, b)) - low;
  const vertices = [...heights.keys()].filter((v) => Math.abs((heights[v]! - low) / extent - 0.5) > 0.4);
  const [c, s] = [Math.cos(Math.PI / 3), Math.sin(Math.PI / 3)];
  const targets = vertices.map((v): [number, number, number] => {
    const [x, y, z] = positions.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
    return y - low > extent / 2 ? [c * x + s * z, y, c * z - s * x] : [x, y, z];
  });
  return { vertices, targets };
}

function open(core: Core, mesh: TestMesh, method: ComparedMethod, parameters: ParameterValues): CoreSession {
  const session = core.open();
  session.load(mesh.positions, mesh.triangles);
  configure(session, mesh, method, parameters);
  return session;
}

function timed(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

/** A run that begins anew whenever it is at its stop; what is timed lies between. */
class LoopedRun {
  readonly #session: CoreSession;

  constructor(session: CoreSession) {
    this.#session = session;
    this.#begin();
  }

  /** Time of some steps, ms. */
  timeSteps(count: number): number {
    let sum = 0;
    for (let k = 0; k < count; k++) {
      let outcome = 'running';
      sum += timed(() => {
        outcome = this.#session.step().outcome;
      });
      if (outcome !== 'running') this.#begin();
    }
    return sum;
  }

  #begin(): void {
    this.#session.restart();
    this.#session.prepare();
    for (let k = 0; k < warmUp; k++) this.#session.step();
  }
}

/** Rounds of both sides; who goes first changes, so that neither always finds the other's caches. */
function timeByTurns(
  sides: Side[],
  mesh: TestMesh,
  method: ComparedMethod,
  parameters: ParameterValues,
): void {
  const sessions = sides.map(({ core }) => open(core, mesh, method, parameters));
  const runs = sides.map((side, s) => ({ side, run: new LoopedRun(sessions[s]!) }));
  for (let round = 0; round < rounds; round++) {
    for (const { side, run } of round % 2 ? runs.toReversed() : runs) {
      const fresh = open(side.core, mesh, method, parameters);
      side.prepares.push(timed(() => fresh.prepare()));
      fresh.free();
      side.iterations.push(run.timeSteps(stepsARound));
    }
  }
  for (const session of sessions) session.free();
}

function runToStop(core: Core, mesh: TestMesh, method: ComparedMethod, parameters: ParameterValues) {
  const start = performance.now();
  const session = open(core, mesh, method, parameters);
  session.prepare();
  let iterations = 0;
  let step = session.step();
  for (iterations = 1; step.outcome === 'running'; iterations++) step = session.step();
  const time = performance.now() - start;
  session.free();
  return { time, iterations, energy: step.energy };
}
