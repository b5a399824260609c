import { spawnSync } from 'node:child_process';
import { cpus } from 'node:os';
import { testCore } from '../fixtures/core.ts';
import { bunnyLevel, type TestMesh } from '../fixtures/meshes.ts';

interface Timing {
  readonly prepare: number; // ms
  readonly iteration: number; // ms
  readonly energy: number;
}

/** Iterations per second that the authors of Cubic Stylization report at about 20k vertices. */
const paperRate = 24;
const rounds = 5;
const iterations = 20;
const lambda = 0.4;

async function timeWasm(mesh: TestMesh): Promise<Timing> {
  const session = (await testCore()).open();
  session.load(mesh.positions, mesh.triangles);
  session.configure('cubic', { lambda, tolerance: 0 });
  const start = performance.now();
  session.prepare();
  const prepared = performance.now();
  let energy = 0;
  for (let k = 0; k < iterations; k++) energy = session.step().energy;
  const done = performance.now();
  session.free();
  return { prepare: prepared - start, iteration: (done - prepared) / iterations, energy };
}

function timeNative(mesh: TestMesh): Timing {
  const counts = Int32Array.of(mesh.positions.length / 3, mesh.triangles.length / 3);
  const input = Buffer.concat(
    [counts, mesh.positions, mesh.triangles].map((array) => Buffer.from(array.buffer)),
  );
  const program = 'wasm/build/native-bench/bench/whittle-bench';
  const { status, stdout, stderr } = spawnSync(program, ['cubic', String(lambda), String(iterations)], {
    input,
  });
  if (status !== 0) throw new Error(`The native benchmark failed: ${stderr}`);
  return JSON.parse(String(stdout)) as Timing;
}

function median(values: number[]): number {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)]!;
}

/** Wasm and native by turns on the bunny at four sizes; ratios are of medians within this one run. */
export async function benchmark(): Promise<void> {
  console.log(
    `cubic, λ ${lambda}, ${iterations} iterations, ${rounds} rounds by turns; ${cpus()[0]?.model}, Node ${process.version}`,
  );
  console.log(
    'vertices | prepare wasm / native | iteration wasm / native | iterations/s wasm (× the paper’s 24) | same energy',
  );
  for (let level = 0; level <= 3; level++) {
    const mesh = bunnyLevel(level);
    const wasm: Timing[] = [];
    const native: Timing[] = [];
    await timeWasm(mesh); // warm up: the first call runs in the baseline tier
    for (let round = 0; round < rounds; round++) {
      wasm.push(await timeWasm(mesh));
      native.push(timeNative(mesh));
    }
    const ratio = (key: 'prepare' | 'iteration'): string =>
      (median(wasm.map((t) => t[key])) / median(native.map((t) => t[key]))).toFixed(2);
    const rate = 1000 / median(wasm.map((t) => t.iteration));
    const difference = Math.abs(wasm[0]!.energy / native[0]!.energy - 1);
    console.log(
      [
        String(mesh.positions.length / 3).padStart(8),
        ratio('prepare').padStart(21),
        ratio('iteration').padStart(23),
        `${rate.toFixed(0)} (${(rate / paperRate).toFixed(1)}×)`.padStart(37),
        difference < 1e-9 ? 'yes' : `off by ${difference.toExponential(1)}`,
      ].join(' | '),
    );
  }
}
