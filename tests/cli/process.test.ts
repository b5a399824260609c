import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeAll, beforeEach, expect, test } from 'vitest';
import { createEngine } from '../../src/engine/client.ts';
import type { Progress } from '../../src/engine/protocol.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { spawnThread } from '../engine/node-thread.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { bunnyLevel, icosphere } from '../fixtures/meshes.ts';
import { until } from '../fixtures/until.ts';
import { Desk } from './harness.ts';

/** The program as `npx whittle` runs it: compiled, in a process of its own. */
const root = fileURLToPath(new URL('../..', import.meta.url));
const program = `${root}/dist/cli/main.js`;
/** Makes the program take its stderr for a terminal, on which it shows how far it is. */
const asTerminal = ['--import', 'data:text/javascript,process.stderr.isTTY=true'];
let desk: Desk;

beforeAll(() => {
  // Set-up compiles what is stale, so that this never tests what was there before an edit.
  execFileSync(process.execPath, [`${root}/wasm/tools/setup.mjs`, 'library']);
});
beforeEach(async () => {
  desk = await Desk.open();
});
afterEach(() => desk.clear());

interface Running {
  readonly child: ReturnType<typeof spawn>;
  readonly said: () => string;
  readonly ended: Promise<Ended>;
}
function start(words: readonly string[], nodeFlags: readonly string[] = []): Running {
  const child = spawn(process.execPath, [...nodeFlags, program, ...words], { cwd: desk.folder });
  let stderr = '';
  child.stderr.on('data', (text) => {
    stderr += text;
  });
  const ended = once(child, 'close').then(([code, signal]) => ({ code, signal, stderr }));
  return { child, said: () => stderr, ended };
}
interface Ended {
  readonly code: number | null;
  readonly signal: string | null;
  readonly stderr: string;
}

test('the compiled program runs, ends by itself and gives exit codes', async () => {
  await desk.write('in.obj', objText(icosphere(1)));
  expect(await start(['cubic', 'in.obj', '--out', 'out.obj']).ended).toEqual({
    code: 0,
    signal: null,
    stderr: '',
  });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj']);
  expect((await start(['cubic', 'no.obj', '--out', 'o.obj']).ended).code).toBe(1);
  expect((await start(['cubic']).ended).code).toBe(2);
});

test('Ctrl-C keeps what there is', async () => {
  await desk.write('in.obj', objText(bunnyLevel(1)));
  // Nothing but the count ends this run within minutes, see `endless` below.
  const words = ['polycube', 'in.obj', '--max-iterations', '1000000', '--out', 'out.obj'];
  const { child, said, ended } = start([...words, '--report', 'report.json'], asTerminal);
  await until(() => /iteration [1-9]/.test(said()) || child.exitCode !== null);
  child.kill('SIGINT');
  expect(await ended).toMatchObject({ code: 0, signal: null });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj', 'report.json']);
  const [step] = JSON.parse(await desk.read('report.json')).steps;
  expect(step.outcome).toBe('cancelled');
});

/**
 * PolyCube starts each iteration anew from what the last one left, without a tolerance: on a shape like the bunny it still moves
 * after many thousands. A ball would become a cube and rest.
 */
const endless = {
  maxIterations: 1_000_000,
  directions: { kind: 'closest', normals: findPrimitive('cube')!.normals },
} as const;

test('in a thread: a run shows frames, is cancelled, and a crash is survived', async () => {
  const workers: ReturnType<typeof spawnThread>[] = [];
  const engine = createEngine({
    spawn: () => {
      workers.push(spawnThread(root));
      return workers.at(-1)!;
    },
  });
  const mesh = bunnyLevel(1);
  const settings = { method: 'polycube', parameters: endless, start: 'rest', positions: true } as const;

  const stop = new AbortController();
  let frames = 0;
  // On a busy machine preparing shows itself as well.
  const onProgress = ({ kind }: Progress) => {
    if (kind === 'iterating' && ++frames === 5) stop.abort();
  };
  const solved = await engine.solve(mesh, settings, { signal: stop.signal, onProgress });
  expect(solved).toMatchObject({ outcome: 'cancelled' });
  expect(solved.iterations).toBeGreaterThanOrEqual(5);
  expect(solved.positions).not.toEqual(mesh.positions);

  const crashing = engine.solve(mesh, settings, { onProgress: () => workers[0]!.crash() });
  const lost = { code: 'worker-lost', message: expect.stringMatching(/crashed on purpose/) };
  await expect(crashing).rejects.toMatchObject(lost);

  const limited = { ...settings, parameters: { ...endless, maxIterations: 4 } };
  const once = await engine.solve(mesh, limited);
  const twice = await engine.solve(mesh, limited);
  expect(workers).toHaveLength(2);
  expect(once).toMatchObject({ outcome: 'iteration-limit', iterations: 4 });
  expect(twice.positions).toEqual(once.positions);
  engine.dispose();
});
