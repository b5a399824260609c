import { chmod, lstat, stat, symlink } from 'node:fs/promises';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { writeWhole } from '../../src/cli/files.ts';
import { createEngine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import { FakeCore, failLambda, fakeServices, trapLambda } from '../engine/fake-core.ts';
import { until } from '../fixtures/until.ts';
import { Desk } from './harness.ts';

let desk: Desk;
beforeEach(async () => {
  desk = await Desk.open();
  core = new FakeCore({ stepMilliseconds: 2 });
  // The fake's files hold a coordinate in each byte.
  await desk.write('in.obj', '\0\0\0\x08\0\0\0\0\0\0\x08\0\0\0\x08');
  await desk.write('out.obj', 'as it was');
});
afterEach(() => desk.clear());

let core: FakeCore;
const engine = () => createEngine({ spawn: () => spawnInProcess(fakeServices(core)) });

const failures: [string, number, RegExp][] = [
  ['a numerical failure', failLambda, /^in\.obj: The system cannot be factorized; use a smaller λ\.\n$/],
  ['a trap', trapLambda, /^in\.obj: Something went wrong inside Whittle/],
];

test.each(failures)('%s ends with 3 and writes nothing', async (_, lambda, message) => {
  const line = `cubic @in.obj --lambda ${lambda} --tolerance 0 --out @out.obj --report @report.json`;
  const said = await desk.run(line, { engine });
  expect(said).toMatchObject({ code: 3, stderr: expect.stringMatching(message) });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj']);
  expect(await desk.read('out.obj')).toBe('as it was');
});

test('what cannot be written leaves the old file as it was', async () => {
  const services = {
    ...fakeServices(core),
    writeMesh: () => {
      throw new WhittleError('unsupported-file', 'This file cannot be given back.');
    },
  };
  const failing = () => createEngine({ spawn: () => spawnInProcess(services) });
  const said = await desk.run('cubic @in.obj --out @out.obj --report @report.json', { engine: failing });
  expect(said).toMatchObject({ code: 1, stderr: 'out.obj: This file cannot be given back.\n' });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj']);
  expect(await desk.read('out.obj')).toBe('as it was');
});

test('an interrupted run is written as far as it came, and later steps are left out', async () => {
  await desk.write('recipe.json', {
    whittle: 1,
    steps: [
      { method: 'cubic', maxIterations: 2, tolerance: 0 },
      { method: 'cubic', maxIterations: 100_000, tolerance: 0 },
      { method: 'arap' },
    ],
  });
  const stop = new AbortController();
  const options = { engine, signal: stop.signal };
  const running = desk.run('run @recipe.json @in.obj --out @out.obj --report @report.json', options);
  // Two are the first step's.
  await until(() => core.steps > 5);
  stop.abort();
  expect((await running).code).toBe(0);
  expect(await desk.read('out.obj')).not.toBe('as it was');
  const { steps } = JSON.parse(await desk.read('report.json'));
  expect(steps).toMatchObject([
    { outcome: 'iteration-limit', iterations: 2 },
    { outcome: 'cancelled', method: 'cubic' },
  ]);
  expect(steps[1].iterations).toBeGreaterThan(0);
  // Each step's mesh is freed before the next one is loaded.
  expect(core).toMatchObject({ opened: 2, freed: 2 });
});

test('interrupted before the first step, nothing is written', async () => {
  const said = await desk.run('cubic @in.obj --out @out.obj', { engine, signal: AbortSignal.abort() });
  expect(said).toMatchObject({ code: 130, stderr: 'whittle: interrupted, nothing was written.\n' });
  expect(await desk.read('out.obj')).toBe('as it was');
});

test('warnings of the file and of the new one go to stderr and into the report', async () => {
  const services = fakeServices(core);
  const warning = 'in.obj: 3 faces use one vertex twice.';
  const readMesh: typeof services.readMesh = async (bytes, name) => ({
    ...(await services.readMesh(bytes, name)),
    warnings: [warning, 'Normals were left out.'],
  });
  const warning2 = () => createEngine({ spawn: () => spawnInProcess({ ...services, readMesh }) });
  const line = 'cubic @in.obj --max-iterations 1 --out @out.obj --report @report.json';
  const said = await desk.run(line, { engine: warning2 });
  expect(said.stderr).toContain('Normals were left out.\n');
  expect(said.stderr.trimEnd().split('\n')).toHaveLength(3);
  const [step] = JSON.parse(await desk.read('report.json')).steps;
  expect(step.warnings).toEqual([warning, 'Normals were left out.', 'no more than that']);
  expect((await desk.run(`${line} --quiet`, { engine: warning2 })).stderr).toBe('');
});

test('a file is written wholly, through links, with its mode, and leaves no draft', async () => {
  await chmod(desk.path('out.obj'), 0o600);
  await symlink('out.obj', desk.path('link.obj'));
  await writeWhole(desk.path('link.obj'), 'new');
  expect(await desk.read('out.obj')).toBe('new');
  expect((await lstat(desk.path('link.obj'))).isSymbolicLink()).toBe(true);
  expect((await stat(desk.path('out.obj'))).mode & 0o777).toBe(0o600);
  expect(await desk.list()).toEqual(['in.obj', 'link.obj', 'out.obj']);
  await expect(writeWhole(desk.path('no/where'), 'x')).rejects.toThrow(/no such file/);
  expect(await desk.list()).toEqual(['in.obj', 'link.obj', 'out.obj']);
});
