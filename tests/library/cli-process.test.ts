import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeAll, beforeEach, expect, test } from 'vitest';
import { createEngine } from '../../src/engine/client.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './cli-harness.ts';
import { spawnThread } from './node-thread.ts';

/** The program as `npx whittle` runs it: compiled, in a process of its own. */
const root = fileURLToPath(new URL('../..', import.meta.url));
const program = `${root}/dist/cli/main.js`;
let desk: Desk;

beforeAll(() => {
  // Set-up has compiled it already; again, so that this never tests what was there before an edit.
  execFileSync(process.execPath, [`${root}/node_modules/typescript/bin/tsc`, '-p', `${root}/src/cli`]);
}, 60_000);
beforeEach(async () => {
  desk = await Desk.open();
});
afterEach(() => desk.clear());

function start(...words: string[]): { child: ReturnType<typeof spawn>; ended: Promise<Ended> } {
  const child = spawn(process.execPath, [program, ...words], { cwd: desk.folder });
  let stderr = '';
  child.stderr.on('data', (text) => {
    stderr += text;
  });
  const ended = once(child, 'close').then(([code, signal]) => ({ code, signal, stderr }));
  return { child, ended };
}
interface Ended {
  readonly code: number | null;
  readonly signal: string | null;
  readonly stderr: string;
}

test('the compiled program runs, ends by itself and gives exit codes', async () => {
  await desk.write('in.obj', objText(icosphere(1)));
  expect(await start('cubic', 'in.obj', '--out', 'out.obj').ended).toEqual({
    code: 0,
    signal: null,
    stderr: '',
  });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj']);
  expect((await start('cubic', 'no.obj', '--out', 'o.obj').ended).code).toBe(1);
  expect((await start('cubic').ended).code).toBe(2);
});

test('Ctrl-C keeps what there is', async () => {
  await desk.write('in.obj', objText(icosphere(6)));
  // The slow way, so that the run does not come to rest before it is stopped.
  const slowly = ['--tolerance', '0', '--max-iterations', '1000000', '--acceleration', 'none'];
  const words = ['cubic', 'in.obj', '--lambda', '0.05', ...slowly];
  const { child, ended } = start(...words, '--out', 'out.obj', '--report', 'report.json');
  // Not a guess of how long it takes: any time within the run will do, and the run is many times longer.
  setTimeout(() => child.kill('SIGINT'), 2500);
  expect(await ended).toEqual({ code: 0, signal: null, stderr: '' });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj', 'report.json']);
  const [step] = JSON.parse(await desk.read('report.json')).steps;
  expect(step.outcome).toBe('cancelled');
}, 60_000);

test('in a thread: a run shows frames, is cancelled at once, and a crash is survived', async () => {
  const workers: ReturnType<typeof spawnThread>[] = [];
  const engine = createEngine({
    spawn: () => {
      workers.push(spawnThread(root));
      return workers.at(-1)!;
    },
  });
  const mesh = icosphere(5);
  const parameters = { lambda: 2, tolerance: 0, maxIterations: 1_000_000 };
  const settings = { method: 'cubic', parameters, start: 'rest', frames: true } as const;

  const stop = new AbortController();
  let asked = 0;
  let frames = 0;
  const onFrame = () => {
    if (++frames !== 5) return;
    asked = performance.now();
    stop.abort();
  };
  const solved = await engine.solve(mesh, settings, { signal: stop.signal, onFrame });
  // 100 ms are promised (about 10 were seen); the rest is for a busy machine.
  expect(performance.now() - asked).toBeLessThan(400);
  expect(solved).toMatchObject({ outcome: 'cancelled' });
  expect(solved.iterations).toBeGreaterThanOrEqual(5);
  expect(solved.positions).not.toEqual(mesh.positions);

  const crashing = engine.solve(mesh, settings, { onFrame: () => workers[0]!.crash() });
  const lost = { code: 'worker-lost', message: expect.stringMatching(/crashed on purpose/) };
  await expect(crashing).rejects.toMatchObject(lost);

  const limited = { ...settings, parameters: { ...parameters, maxIterations: 4 } };
  const once = await engine.solve(mesh, limited);
  const twice = await engine.solve(mesh, limited);
  expect(workers).toHaveLength(2);
  expect(once).toMatchObject({ outcome: 'iteration-limit', iterations: 4 });
  expect(twice.positions).toEqual(once.positions);
  engine.dispose();
}, 60_000);
