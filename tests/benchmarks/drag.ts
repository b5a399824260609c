import { performance } from 'node:perf_hooks';
import type { Engine } from '../../src/engine/client.ts';
import { createNodeEngine } from '../../src/engine/in-node.ts';
import type { Solved } from '../../src/engine/protocol.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { row } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { bunnyLevel, type TestMesh } from '../fixtures/meshes.ts';
import { caseOf, meshed } from '../shapes/cases.ts';
import { stretched } from '../shapes/gestures.ts';
import { diagonalOf, farthest, median } from './numbers.ts';

/** How quickly a drag is followed: as the page does it, a new target with every picture, the newest wins. */

const pictures = 60;
const seconds = 3;

const sleep = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** A mesh and what is dragged: all of it where `share` is 1. */
interface Drag {
  readonly name: string;
  readonly method: string;
  readonly mesh: Mesh;
  readonly handles: (share: number) => Handles;
  /** Iterations that an answer must have to count as a whole one, unless it converged before. */
  readonly wholeFrom: number;
}

/** The lowest tenth of the height held, the highest moved. */
function ofEnds(mesh: TestMesh, method: string): Drag {
  const heights = Float64Array.from(
    { length: mesh.positions.length / 3 },
    (_, v) => mesh.positions[3 * v + 1]!,
  );
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const [height, reach] = [high - low, (high - low) / 10];
  const held = [...heights.keys()].filter((v) => heights[v]! < low + reach);
  const moved = [...heights.keys()].filter((v) => heights[v]! > high - reach);
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
  return { name: `${heights.length} vertices`, method, mesh, handles, wholeFrom: 4 };
}

/** A shape of about so many faces, reshaped by whole sides. */
function ofSides(name: string, gesture: string, faces: number): Drag {
  const chosen = caseOf(name);
  let scale = 0.5;
  for (let round = 0; round < 3; round++)
    scale *= Math.sqrt(meshed(chosen, scale).triangles.length / 3 / faces);
  const shape = meshed(chosen, scale);
  const { vertices, targets } = stretched(shape, chosen.gestures[gesture]!);
  const handles = (share: number): Handles => ({
    vertices,
    targets: targets.map((target, i) => {
      const from = row(shape.positions, vertices[i]!);
      return [0, 1, 2].map(
        (axis) => from[axis]! + share * (target[axis]! - from[axis]!),
      ) as unknown as typeof target;
    }),
  });
  const title = `${name}, ${gesture}, ${shape.triangles.length / 3} faces`;
  return { name: title, method: 'reshape', mesh: shape, handles, wholeFrom: 3 };
}

async function follow(engine: Engine, { name, method, mesh, handles, wholeFrom }: Drag): Promise<void> {
  const solve = (share: number, start: 'rest' | 'current') =>
    engine.solve(mesh, { method, parameters: { handles: handles(share) }, start, positions: true });
  await solve(0, 'rest');
  const answers: Promise<{ share: number; solved: Solved }>[] = [];
  const began = performance.now();
  for (let picture = 0; picture < seconds * pictures; picture++) {
    const due = began + (1000 * picture) / pictures;
    if (due > performance.now()) await sleep(due - performance.now());
    const share = picture / (seconds * pictures);
    answers.push(solve(share, 'current').then((solved) => ({ share, solved })));
  }
  const released = performance.now();
  const settled = await solve(1, 'rest');
  const last = performance.now() - released;
  const shown = (await Promise.all(answers)).filter(({ solved }) => solved.iterations > 0);
  const whole = shown.filter(
    ({ solved }) => solved.iterations >= wholeFrom || solved.outcome === 'converged',
  );
  const rate = (count: number) => ((1000 * count) / (released - began)).toFixed(1);

  // The answers while it went on against those that are worked out from rest.
  const errors: number[] = [];
  for (const share of method === 'reshape' ? [0.3, 0.6, 0.95] : []) {
    const near = shown.find((answer) => answer.share >= share) ?? shown.at(-1)!;
    const { positions } = await solve(near.share, 'rest');
    errors.push(farthest(near.solved.positions, positions) / diagonalOf(mesh.positions));
  }
  const off = errors.map((error) => `${(100 * error).toFixed(2)} %`).join(', ');
  console.log(
    `${method}, ${name}: ${rate(shown.length)} solves a second, ${rate(whole.length)} of ${wholeFrom} iterations or more ` +
      `(median ${median(shown.map(({ solved }) => solved.iterations))}), ${settled.iterations} to settle, ` +
      `the last frame ${last.toFixed(0)} ms after release${off && `; on the way off by ${off} of the diagonal`}`,
  );
}

/** Prints it for the methods that take handles, on two sizes of the bunny, and for reshaping on shapes of 8500 faces. */
export async function benchmarkDrags(): Promise<void> {
  const engine = createNodeEngine();
  for (const method of ['arap', 'cubic'])
    for (const level of [1, 2]) await follow(engine, ofEnds(bunnyLevel(level), method));
  const gestures = [
    ['drilled plate', 'lengthen'],
    ['bracket', 'lengthen'],
    ['mug', 'raise'],
    ['cylinder', 'lengthen'],
    ['lamp', 'raise'],
  ] as const;
  for (const [name, gesture] of gestures) await follow(engine, ofSides(name, gesture, 8500));
  engine.dispose();
}
