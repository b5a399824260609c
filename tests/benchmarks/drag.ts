import { performance } from 'node:perf_hooks';
import type { Engine } from '../../src/engine/client.ts';
import { createNodeEngine } from '../../src/engine/in-node.ts';
import type { Solved } from '../../src/engine/protocol.ts';
import { row } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { bunnyLevel, type TestMesh } from '../fixtures/meshes.ts';

/** How quickly a drag is followed: as the page does it, a new target with every picture, the newest wins. */

const pictures = 60;
const seconds = 3;

const sleep = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** The lowest held, the highest moved: each a tenth of the height. */
function ends({ positions }: TestMesh) {
  const heights = Float64Array.from({ length: positions.length / 3 }, (_, v) => positions[3 * v + 1]!);
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const reach = (high - low) / 10;
  const all = [...heights.keys()];
  return {
    held: all.filter((v) => heights[v]! < low + reach),
    moved: all.filter((v) => heights[v]! > high - reach),
    height: high - low,
  };
}

async function drag(engine: Engine, mesh: TestMesh, method: string): Promise<void> {
  const { held, moved, height } = ends(mesh);
  const handles = (share: number): Handles => ({
    vertices: [...held, ...moved],
    targets: [
      ...held.map((v) => row(mesh.positions, v)),
      ...moved.map((v) => {
        const [x, y, z] = row(mesh.positions, v);
        return [x + share * height, y + 0.3 * share * height, z] as const;
      }),
    ],
  });
  const solve = (share: number, start: 'rest' | 'current') =>
    engine.solve(mesh, { method, parameters: { handles: handles(share) }, start, positions: true });
  await solve(0, 'rest');
  const runs: Promise<Solved>[] = [];
  const began = performance.now();
  for (let picture = 0; picture < seconds * pictures; picture++) {
    const due = began + (1000 * picture) / pictures;
    if (due > performance.now()) await sleep(due - performance.now());
    runs.push(solve(picture / (seconds * pictures), 'current'));
  }
  const released = performance.now();
  const settled = await solve(1, 'rest');
  const last = performance.now() - released;
  const solved = (await Promise.all(runs)).filter(({ iterations }) => iterations > 0);
  const whole = solved.filter(({ iterations, outcome }) => iterations >= 4 || outcome === 'converged');
  const rate = (count: number) => ((1000 * count) / (released - began)).toFixed(1);
  const count = mesh.positions.length / 3;
  console.log(
    `${method}, ${count} vertices: ${rate(solved.length)} solves a second, ${rate(whole.length)} of 4 iterations or more, ` +
      `${settled.iterations} to settle, the last frame ${last.toFixed(0)} ms after release`,
  );
}

/** Prints it for the methods that take handles, on two sizes of the bunny. */
export async function benchmarkDrags(): Promise<void> {
  const engine = createNodeEngine();
  for (const method of ['arap', 'cubic'])
    for (const level of [1, 2]) await drag(engine, bunnyLevel(level), method);
  engine.dispose();
}
