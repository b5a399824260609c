import { afterEach, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { Progress, Solved, SolveSettings } from '../../src/engine/protocol.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { until } from '../fixtures/until.ts';
import { FakeCore, type FakeOptions, failLambda, fakeServices, tetrahedron } from './fake-core.ts';

let engine: Engine;
let core: FakeCore;
function start(options?: FakeOptions): void {
  core = new FakeCore(options);
  engine = createEngine({ spawn: () => spawnInProcess(fakeServices(core)) });
}
afterEach(() => engine.dispose());

function settings(parameters: ParameterValues = {}, more: Partial<SolveSettings> = {}): SolveSettings {
  return { method: 'cubic', parameters, start: 'rest', positions: false, ...more };
}
/** Runs until somebody stops it. */
const endless = { tolerance: 0, maxIterations: 1_000_000 };

test('files are read and written, and the caller keeps its bytes', async () => {
  start();
  const bytes = new Uint8Array([0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 8]);
  const { mesh, format } = await engine.read(bytes, 'a.fake');
  expect(format).toBe('off');
  expect([...mesh.positions]).toEqual([...bytes]);
  const positions = new Float64Array([1, 2]);
  const written = await engine.write(bytes.subarray(0, 2), 'a.fake', 'fake', positions);
  expect(written).toEqual({ bytes: Uint8Array.of(0, 0, 1, 2), warnings: ['no more than that'] });
  expect(bytes.length).toBe(15);
  expect(positions.length).toBe(2);
  expect(core.opened).toBe(0);
});

test('a refusal of the files arrives with its code', async () => {
  start();
  const write = engine.write(new Uint8Array(1), 'a', 'bad', new Float64Array(3));
  await expect(write).rejects.toMatchObject({ name: 'WhittleError', code: 'unknown-format' });
});

test('a mesh is welded, loaded once, and answered in file order', async () => {
  start();
  const mesh = tetrahedron();
  const report = await engine.inspect(mesh);
  expect(report.vertices).toBe(4);
  const solved = await engine.solve(mesh, settings({ maxIterations: 2, tolerance: 0 }));
  expect(solved).toMatchObject({ outcome: 'iteration-limit', iterations: 2 });
  // Half of the way to one half, twice.
  expect([...solved.positions]).toEqual([0, 0, 0, 5, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0, 5]);
  expect(solved.energy).toEqual([48, 12]);
  expect(core.log).toEqual(['load', 'configure cubic', 'restart', 'prepare']);
});

test('a run may go on from the current positions', async () => {
  start();
  const mesh = tetrahedron();
  const once = settings({ maxIterations: 1, tolerance: 0 });
  await engine.solve(mesh, once);
  const second = await engine.solve(mesh, { ...once, start: 'current' });
  expect(second.positions[3]).toBe(5);
  const fresh = await engine.solve(mesh, once);
  expect(fresh.positions[3]).toBe(6);
});

test('a vertex that the core names is named as the file names it', async () => {
  start();
  const mesh = tetrahedron([0, 0, 0, 8, 0, 0, 0, 0, 0, 0, Number.NaN, 0, 0, 0, 8]);
  const refused = engine.inspect(mesh);
  await expect(refused).rejects.toMatchObject({
    ...{ code: 'not-finite', element: 3, message: 'Vertex 3 is not finite; repair the file.' },
  });
  expect(core.freed).toBe(1);
});

test('handles are given in file numbering', async () => {
  start();
  const handles = {
    vertices: [2, 4, 0],
    targets: [[1, 1, 1] as const, [2, 2, 2] as const, [1, 1, 1] as const],
  };
  const solved = await engine.solve(tetrahedron(), settings({ handles }, { method: 'arap' }));
  expect([...core.handles[0]!.indices]).toEqual([0, 3]);
  expect([...core.handles[0]!.numbers]).toEqual([1, 1, 1, 2, 2, 2]);
  expect(solved.positions[6]).toBeCloseTo(1, 2);
  expect(solved.positions[12]).toBeCloseTo(2, 2);
});

const bad: [string, SolveSettings, string, RegExp][] = [
  ['an unknown method', { ...settings(), method: 'cubik' }, 'unknown-method', /“cubik”.*mean “cubic”/],
  ['an unknown parameter', settings({ lamda: 1 }), 'bad-parameter', /“lamda”.*mean “lambda”/],
  ['a number out of range', settings({ lambda: -1 }), 'bad-parameter', /“lambda”.* 0 to 100, not -1/],
  ['a number that is none', settings({ lambda: Number.NaN }), 'bad-parameter', /“lambda”.*not NaN/],
  ['a fraction of an iteration', settings({ maxIterations: 1.5 }), 'bad-parameter', /whole number.*1\.5/],
  ['a text for a number', settings({ lambda: '1' }), 'bad-parameter', /not "1"/],
  ['no such vertex', handle([5], [[0, 0, 0]]), 'bad-handles', /vertex 5.*5 vertices/],
  ['targets missing', handle([1, 2], [[0, 0, 0]]), 'bad-handles', /2 vertices and 1 targets/],
  ['a target not finite', handle([1], [[0, Infinity, 0]]), 'bad-handles', /entry 0 is \[0,"Infinity",0\]/],
  ['a vertex twice', handle([1, 1], [[0, 0, 0], [1, 0, 0]]), 'bad-handles', /vertex 1 two different/], // biome-ignore format: short
  ['a plane of no such vertex', settings({ planes: [{ vertices: [5], normal: [1, 0, 0], offset: 0 }] }), 'bad-planes', /vertex 5 in plane 0.*5 vertices/], // biome-ignore format: short
  ['a plane without a direction', settings({ planes: [{ vertices: [1], normal: [0, 0, 0], offset: 0 }] }), 'bad-planes', /plane 0 is \[0,0,0\]/], // biome-ignore format: short
  ['a seam torn', handle([0, 2], [[0, 0, 0], [1, 0, 0]]), 'bad-handles', /vertices 0 and 2 different/], // biome-ignore format: short
];
function handle(vertices: number[], targets: [number, number, number][]): SolveSettings {
  return settings({ handles: { vertices, targets } });
}

test.each(bad)('%s is refused before the core hears of it', async (_, request, code, message) => {
  start();
  const solve = engine.solve(tetrahedron(), request);
  await expect(solve).rejects.toMatchObject({ code, message: expect.stringMatching(message) });
  expect(core.log).toEqual(['load']);
});

test('the latest request wins, and every earlier one keeps what it has', async () => {
  start();
  const mesh = tetrahedron();
  await engine.inspect(mesh);
  let seen = 0;
  const onProgress = ({ kind }: Progress) => {
    if (kind === 'iterating') seen++;
  };
  const first = engine.solve(mesh, settings(endless, { positions: true }), { onProgress });
  await until(() => seen > 0);
  const second = engine.solve(mesh, settings(endless));
  const third = engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 }));

  expect(await first).toMatchObject({ outcome: 'cancelled' });
  expect((await first).iterations).toBeGreaterThan(0);
  expect((await first).energy).toHaveLength((await first).iterations);
  expect(await second).toMatchObject({ outcome: 'cancelled', iterations: 0 });
  expect(await third).toMatchObject({ outcome: 'iteration-limit', iterations: 1 });
  expect((await third).positions[3]).toBe(6);
  expect(core.log.filter((line) => line === 'prepare')).toHaveLength(2);
});

test('a run from the current shape means what the run it overtakes would have begun with', async () => {
  start();
  const mesh = tetrahedron();
  await engine.solve(mesh, settings({ maxIterations: 2, tolerance: 0 }));
  const overtaken = engine.solve(mesh, settings(endless));
  const latest = engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 }, { start: 'current' }));
  expect(await overtaken).toMatchObject({ outcome: 'cancelled', iterations: 0 });
  expect((await latest).positions[3]).toBe(6);
});

test('requests that come faster than they can be prepared still make headway', async () => {
  start({ prepareMilliseconds: 12 });
  const mesh = tetrahedron();
  await engine.inspect(mesh);
  const runs: Promise<Solved>[] = [];
  for (let request = 0; request < 30; request++) {
    runs.push(engine.solve(mesh, settings(endless, { start: 'current' })));
    await new Promise((resolve) => setTimeout(resolve, 2));
  }
  runs.push(engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 })));
  const iterations = (await Promise.all(runs)).map((solved) => solved.iterations);
  const prepared = core.log.filter((line) => line === 'prepare').length;
  expect(prepared).toBeGreaterThan(2);
  expect(iterations.filter((count) => count > 0)).toHaveLength(prepared);
});

test('a request that is refused leaves the run before it alone', async () => {
  start({ stepMilliseconds: 2 });
  const mesh = tetrahedron();
  const running = engine.solve(mesh, settings({ maxIterations: 20, tolerance: 0 }));
  await expect(engine.solve(mesh, settings({ lambda: -1 }))).rejects.toMatchObject({ code: 'bad-parameter' });
  expect(await running).toMatchObject({ outcome: 'iteration-limit', iterations: 20 });
});

test('two meshes run side by side', async () => {
  start({ stepMilliseconds: 1 });
  const stop = new AbortController();
  const long = engine.solve(tetrahedron(), settings(endless), { signal: stop.signal });
  const short = await engine.solve(tetrahedron(), settings({ maxIterations: 3, tolerance: 0 }));
  expect(short.iterations).toBe(3);
  stop.abort();
  expect((await long).outcome).toBe('cancelled');
});

test('a cancelled run answers within 100 ms with what it has', async () => {
  start({ stepMilliseconds: 3 });
  const mesh = tetrahedron();
  const stop = new AbortController();
  const running = engine.solve(mesh, settings(endless), { signal: stop.signal });
  await until(() => core.steps > 10);
  const stepsSoFar = core.steps;
  stop.abort();
  const solved = await running;
  // Counted in steps: the machine that runs this may be busy with other things.
  expect(core.steps - stepsSoFar).toBeLessThan(100 / 3 / 2);
  expect(solved.outcome).toBe('cancelled');
  expect(solved.iterations).toBeGreaterThan(0);
  expect(solved.positions[3]).toBeLessThan(8);
});

test('a run that is cancelled before it begins does not begin', async () => {
  start();
  const solved = await engine.solve(tetrahedron(), settings(endless), { signal: AbortSignal.abort() });
  expect(solved).toMatchObject({ outcome: 'cancelled', iterations: 0 });
  expect(solved.positions[3]).toBe(8);
  expect(core.log).toEqual(['load']);
});

test('other calls reject with the reason of the signal', async () => {
  start();
  const signal = AbortSignal.abort(new Error('changed my mind'));
  await expect(engine.inspect(tetrahedron(), { signal })).rejects.toThrow('changed my mind');
  expect(core.log).toEqual([]);
  const stop = new AbortController();
  const reading = engine.read(new Uint8Array(15), 'a.fake', { signal: stop.signal });
  stop.abort(new Error('later'));
  await expect(reading).rejects.toThrow('later');
});

test('after a numerical failure the mesh starts from its rest', async () => {
  start();
  const mesh = tetrahedron();
  const failing = engine.solve(mesh, settings({ lambda: failLambda, tolerance: 0 }));
  await expect(failing).rejects.toMatchObject({ code: 'numerical-failure' });
  const next = await engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 }, { start: 'current' }));
  expect(next.positions[3]).toBe(6);
});

test('no iterations means the rest shape', async () => {
  start();
  const solved = await engine.solve(tetrahedron(), settings({ maxIterations: 0 }));
  expect(solved).toMatchObject({ outcome: 'iteration-limit', iterations: 0, energy: [] });
  expect(core.steps).toBe(0);
});

test('a released mesh is freed, its run stopped, and it can come back', async () => {
  start();
  const mesh = tetrahedron();
  await engine.inspect(mesh);
  const running = engine.solve(mesh, settings(endless));
  await until(() => core.steps > 0);
  engine.release(mesh);
  expect((await running).outcome).toBe('cancelled');
  await engine.inspect(mesh);
  expect(core).toMatchObject({ opened: 2, freed: 1 });
});

test('a mesh that is released while it loads is freed all the same', async () => {
  start();
  const mesh = tetrahedron();
  const solving = engine.solve(mesh, settings(endless));
  engine.release(mesh);
  const again = engine.inspect(mesh);
  expect((await solving).outcome).toBe('cancelled');
  await again;
  expect((await engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 }))).iterations).toBe(1);
  expect(core).toMatchObject({ opened: 2, freed: 1 });
});
