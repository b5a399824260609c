import { afterEach, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { ClientPort } from '../../src/engine/port.ts';
import type { SolveSettings } from '../../src/engine/protocol.ts';
import { inCore } from '../../src/engine/trap.ts';
import { FakeCore, fakeServices, tetrahedron, trapLambda } from './fake-core.ts';

let engine: Engine;
let workers: ClientPort[];
let cores: FakeCore[];
function start(): void {
  workers = [];
  cores = [];
  engine = createEngine({
    spawn: () => {
      cores.push(new FakeCore());
      workers.push(spawnInProcess(fakeServices(cores.at(-1)!)));
      return workers.at(-1)!;
    },
  });
}
afterEach(() => engine.dispose());

const endless = { tolerance: 0, maxIterations: 1_000_000 };
function settings(parameters: SolveSettings['parameters']): SolveSettings {
  return { method: 'cubic', parameters, start: 'current', frames: false };
}

test('a worker that dies rejects all that waits, and the next call starts another that knows the mesh', async () => {
  start();
  const mesh = tetrahedron();
  const solving = engine.solve(mesh, settings(endless));
  const reading = engine.read(new Uint8Array(15), 'a.fake');
  await engine.inspect(mesh);
  const lost = {
    name: 'WhittleError',
    code: 'worker-lost',
    message: expect.stringMatching(/no such script/),
  };
  const both = Promise.all([
    expect(solving).rejects.toMatchObject(lost),
    // The read was answered before; a second one is under way.
    reading.then(() => {
      const second = engine.read(new Uint8Array(15), 'a.fake');
      workers[0]!.onerror?.({ message: 'no such script' } as ErrorEvent);
      return expect(second).rejects.toMatchObject(lost);
    }),
  ]);
  await both;
  const solved = await engine.solve(mesh, settings({ maxIterations: 1, tolerance: 0 }));
  expect(solved.positions[3]).toBe(6);
  expect(workers).toHaveLength(2);
  expect(cores[1]!.log[0]).toBe('load');
});

test('a message that cannot be read counts as a loss', async () => {
  start();
  const reading = engine.read(new Uint8Array(15), 'a.fake');
  workers[0]!.onmessageerror?.({} as MessageEvent);
  await expect(reading).rejects.toMatchObject({ code: 'worker-lost' });
});

test('a trap of the core fails its own request as internal and takes the worker along', async () => {
  start();
  const bystander = engine.solve(tetrahedron(), settings(endless));
  const lost = expect(bystander).rejects.toMatchObject({ code: 'worker-lost' });
  const mesh = tetrahedron();
  const trapped = engine.solve(mesh, settings({ lambda: trapLambda, tolerance: 0 }));
  await expect(trapped).rejects.toMatchObject({ code: 'internal' });
  await lost;
  await engine.solve(mesh, settings({ maxIterations: 1 }));
  expect(workers).toHaveLength(2);
});

test('a trap for want of memory says so', () => {
  const abort = () => {
    throw new WebAssembly.RuntimeError('Aborted(OOM)');
  };
  expect(() => inCore(abort, () => 0)).toThrow(
    expect.objectContaining({ failure: expect.objectContaining({ code: 'out-of-memory' }) }),
  );
  const unreachable = () => {
    throw new WebAssembly.RuntimeError('unreachable');
  };
  expect(() => inCore(unreachable, () => 2 ** 32)).toThrow(
    expect.objectContaining({ failure: expect.objectContaining({ code: 'out-of-memory' }) }),
  );
  expect(() => inCore(unreachable, () => 0)).toThrow(
    expect.objectContaining({ failure: expect.objectContaining({ code: 'internal' }) }),
  );
});

test('a core that could not be loaded is tried again', async () => {
  let tries = 0;
  const core = new FakeCore();
  const loadCore = async () => {
    if (++tries === 1) throw new Error('404');
    return core;
  };
  engine = createEngine({ spawn: () => spawnInProcess({ ...fakeServices(core), loadCore }) });
  const mesh = tetrahedron();
  await expect(engine.inspect(mesh)).rejects.toMatchObject({ code: 'internal' });
  await expect(engine.inspect(mesh)).resolves.toMatchObject({ vertices: 4 });
});

test('a worker that cannot be started is a loss with its reason', async () => {
  engine = createEngine({
    spawn: () => {
      throw new Error('blocked by policy');
    },
  });
  const lost = { code: 'worker-lost', message: expect.stringMatching(/blocked by policy/) };
  await expect(engine.inspect(tetrahedron())).rejects.toMatchObject(lost);
});

test('a disposed engine rejects what waits and what comes', async () => {
  start();
  const pending = engine.solve(tetrahedron(), settings(endless));
  await engine.read(new Uint8Array(15), 'a.fake');
  engine.dispose();
  await expect(pending).rejects.toMatchObject({ code: 'worker-lost' });
  await expect(engine.inspect(tetrahedron())).rejects.toMatchObject({ code: 'worker-lost' });
  expect(workers).toHaveLength(1);
});
