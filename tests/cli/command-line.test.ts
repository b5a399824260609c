import { afterEach, beforeEach, expect, test } from 'vitest';
import { methods } from '../../src/methods/registry.ts';
import { objPositions, objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { Desk } from './harness.ts';

let desk: Desk;
const ball = objText(icosphere(2));
const without = (text: string) => text.split('\n').filter((line) => !line.startsWith('v '));
beforeEach(async () => {
  desk = await Desk.open();
  await desk.write('in.obj', ball);
});
afterEach(() => desk.clear());

test('a method carves a mesh, keeps the rest of the file and reports', async () => {
  const said = await desk.run('cubic @in.obj --lambda 0.4 --out @out.obj --report @report.json');
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  expect(await desk.list()).toEqual(['in.obj', 'out.obj', 'report.json']);
  expect(await desk.read('in.obj')).toBe(ball);
  const out = await desk.read('out.obj');
  expect(without(out)).toEqual(without(ball));
  expect(objPositions(out)).not.toEqual(objPositions(ball));

  const { input, steps, ...more } = JSON.parse(await desk.read('report.json'));
  expect(more).toEqual({});
  expect(input).toEqual({
    ...{ vertices: 162, faces: 320, components: 1 },
    ...{ boundaryEdges: 0, nonManifoldEdges: 0, degenerateFaces: 0 },
  });
  expect(steps).toHaveLength(1);
  const { method, iterations, outcome, energy, milliseconds, warnings, ...rest } = steps[0];
  expect({ method, outcome, warnings, rest }).toEqual({
    ...{ method: 'cubic', outcome: 'converged', warnings: [], rest: {} },
  });
  expect(energy).toHaveLength(iterations);
  expect(energy.at(-1)).toBeLessThan(energy[0]);
  expect(Object.keys(milliseconds).sort()).toEqual(['prepare', 'read', 'solve', 'write']);
  for (const time of Object.values(milliseconds)) expect(time).toBeGreaterThan(0);
});

test('parameters matter: no cubeness gives the mesh back, an iteration limit is kept', async () => {
  await desk.run('cubic @in.obj --lambda 0 --out @same.obj');
  objPositions(await desk.read('same.obj')).forEach((coordinate, index) => {
    expect(coordinate).toBeCloseTo(objPositions(ball)[index]!, 9);
  });
  await desk.run('cubic @in.obj --max-iterations=3 --tolerance 0 --out @out.obj --report @report.json');
  const [step] = JSON.parse(await desk.read('report.json')).steps;
  expect(step).toMatchObject({ iterations: 3, outcome: 'iteration-limit' });
});

test('handles come from a JSON file and are met', async () => {
  await desk.write('handles.json', { vertices: [0, 3], targets: [[0, 0, 0], [0, 0, 2]] }); // biome-ignore format: pairs
  expect((await desk.run('arap @in.obj --handles @handles.json --out @out.obj')).code).toBe(0);
  const positions = objPositions(await desk.read('out.obj'));
  expect(positions.slice(0, 3).map((x) => x + 0)).toEqual([0, 0, 0]);
  expect(Math.hypot(positions[9]!, positions[10]!, positions[11]! - 2)).toBeLessThan(1e-8);
});

test('landmarks stretch, those that are fixed stay, and the report says what was far', async () => {
  const source = objPositions(ball);
  await desk.write('landmarks.json', { vertices: [0], targets: [[0, 0, 30]], fixed: [3] });
  const said = await desk.run(
    'plastic @in.obj --landmarks @landmarks.json --max-iterations 2 --out @out.obj --report @report.json',
  );
  expect(said.code).toBe(0);
  const positions = objPositions(await desk.read('out.obj'));
  expect(positions.slice(9, 12)).toEqual(source.slice(9, 12));
  const [step] = JSON.parse(await desk.read('report.json')).steps;
  expect(step).toMatchObject({ method: 'plastic', iterations: 2, outcome: 'iteration-limit' });
  expect(step.warnings.join(' ')).toMatch(/times as far apart/);
  expect(step.warnings.join(' ')).toMatch(/missed by/);
});

test('a recipe is the same as its steps one after the other', async () => {
  const handles = { vertices: [0, 3], targets: [[0, 0, 1], [0, 0, -2]] }; // biome-ignore format: pairs
  await desk.write('recipe.json', {
    whittle: 1,
    steps: [
      { method: 'cubic', lambda: 0.4 },
      { method: 'arap', handles },
    ],
    // Names for people: no step depends on them.
    groups: [{ name: 'pole', vertices: [0, 9999] }],
  });
  await desk.write('handles.json', handles);
  const said = await desk.run('run @recipe.json @in.obj --out @out.obj --report @report.json');
  expect(said).toEqual({ code: 0, stdout: '', stderr: '' });
  await desk.run('cubic @in.obj --lambda 0.4 --out @half.obj');
  await desk.run('arap @half.obj --handles @handles.json --out @whole.obj');
  const whole = objPositions(await desk.read('whole.obj'));
  objPositions(await desk.read('out.obj')).forEach((coordinate, index) => {
    expect(coordinate).toBeCloseTo(whole[index]!, 6);
  });

  const { steps } = JSON.parse(await desk.read('report.json'));
  expect(steps.map(({ method }: { method: string }) => method)).toEqual(['cubic', 'arap']);
  expect(steps[0].milliseconds).toMatchObject({ read: expect.any(Number), write: 0 });
  expect(steps[1].milliseconds).toMatchObject({ read: 0, write: expect.any(Number) });
  expect(steps[0].milliseconds.read).toBeGreaterThan(0);
  expect(steps[1].milliseconds.write).toBeGreaterThan(0);
});

test('the result may go over the input if --out says so', async () => {
  expect((await desk.run('cubic @in.obj --out @in.obj')).code).toBe(0);
  expect(await desk.list()).toEqual(['in.obj']);
  expect(await desk.read('in.obj')).not.toBe(ball);
});

test('vertices without a face stay, with a warning', async () => {
  await desk.write('in.obj', ball.replace('g all', 'v 9 9 9\nv 8 8 8\ng all'));
  const said = await desk.run('cubic @in.obj --out @out.obj');
  expect(said).toMatchObject({
    code: 0,
    stderr: 'in.obj: 2 vertices belong to no face and stay where they are, unless they are handles.\n',
  });
  expect(objPositions(await desk.read('out.obj')).slice(-6)).toEqual([9, 9, 9, 8, 8, 8]);
});

test('every method of the registry is listed, for people and for machines', async () => {
  const { stdout } = await desk.run('methods');
  for (const { id, summary, parameters } of methods) {
    expect(stdout).toContain(`${id}: ${summary}`);
    for (const { doc } of parameters) expect(stdout).toContain(doc);
  }
  expect(stdout).toMatch(/--max-iterations COUNT +0 to 1000000, default 1000/);
  expect(JSON.parse((await desk.run('methods --json')).stdout)).toEqual(JSON.parse(JSON.stringify(methods)));
  expect((await desk.run('arap --help')).stdout).not.toContain('--lambda');
  const { stdout: help } = await desk.run('--help');
  for (const { id } of methods) expect(help).toContain(`\n  ${id} `);
  expect((await desk.run('--version')).stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
});

test('progress is one line, on a terminal only', async () => {
  const line = 'cubic @in.obj --tolerance 0 --max-iterations 200 --out @out.obj';
  const { stderr } = await desk.run(line, { isTTY: true });
  expect(stderr).toContain('\rreading');
  expect(stderr.trimEnd().split('\n')).toHaveLength(1);
  expect(stderr.split('\x1b[K').at(-1)).toMatch(/^out\.obj: cubic, \d+ iterations, [a-z-]+, \d+\.\d s\n$/);
  expect((await desk.run(`${line} --quiet`, { isTTY: true })).stderr).toBe('');
  expect((await desk.run(line)).stderr).toBe('');
});

const wrong: [string, number, RegExp][] = [
  ['cubik @in.obj --out @o.obj', 2, /^whittle: .*cubik.*“cubic”/],
  ['cubic --out @o.obj', 2, /name the mesh file/],
  ['cubic @in.obj', 2, /--out out\.obj/],
  ['cubic @in.obj --out', 2, /--out needs a value/],
  ['cubic @in.obj @b.obj --out @o.obj', 2, /b\.obj is too many/],
  ['cubic @in.obj --out @o.obj --lamda 1', 2, /--lamda here.*“--lambda”/],
  ['cubic @in.obj --out @o.obj --lambda -1', 2, /“lambda” .* 0 to 100, not -1/],
  ['cubic @in.obj --out @o.obj --lambda much', 2, /not "much"/],
  ['cubic @in.obj --out @o.obj --lambda=', 2, /not ""/],
  ['cubic @in.obj --out @o.obj --lambda 1 --lambda 2', 2, /--lambda is given twice/],
  ['cubic @in.obj --out @o.obj --quiet=yes', 2, /--quiet takes no value/],
  ['cubic @in.obj --out @o.doc', 2, /--out o\.doc: .*\.obj/],
  ['methods now', 2, /takes no now/],
  ['run', 2, /whittle run recipe\.json/],
  ['cubic @no.obj --out @o.obj', 1, /^no\.obj: there is no such file/],
  ['cubic @in.obj --out @no/o.obj', 1, /^no\/o\.obj: there is no folder/],
  ['cubic @in.obj --out @o.obj --report @o.obj', 2, /--report o\.obj would overwrite the mesh/],
  ['cubic @in.obj --out @o.obj --report @in.obj', 2, /--report in\.obj would overwrite the mesh/],
  ['cubic @in.obj --out @o.obj --report @no/r.json', 1, /^no\/r\.json: there is no folder/],
  ['cubic @broken.obj --out @o.obj', 1, /^broken\.obj.*line 2/],
  ['cubic @flat.obj --out @o.obj', 1, /^flat\.obj: All vertices lie in one point.*\.\n$/],
  ['arap @in.obj --out @o.obj --handles @no.json', 1, /^no\.json: there is no such file/],
  ['arap @in.obj --out @o.obj --handles @broken.json', 1, /^broken\.json, line 2: /],
  ['arap @in.obj --out @o.obj --handles @shape.json', 1, /^shape\.json: “handles” must be/],
  [
    'arap @in.obj --out @o.obj --handles @far.json',
    1,
    /^in\.obj: “handles” names vertex 162, .*\(0 to 161\)/,
  ],
  ['run @broken.json @in.obj --out @o.obj', 1, /^broken\.json, line 2: /],
  ['run @recipe.json @in.obj --out @o.obj', 1, /^recipe\.json, step 2: .*“lamda”/],
  ['run @late.json @in.obj --out @o.obj', 1, /^in\.obj, step 2 \(arap\): “handles” names vertex 999/],
];

test.each(wrong)('whittle %s ends with %i in one line and writes nothing', async (line, code, message) => {
  await desk.write('broken.obj', 'v 0 0 0\nv 1 x 0\nv 0 1 0\nf 1 2 3\n');
  await desk.write('flat.obj', 'v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n');
  await desk.write('broken.json', '{\n"vertices": [0}');
  await desk.write('shape.json', [1]);
  await desk.write('far.json', { vertices: [162], targets: [[0, 0, 0]] });
  await desk.write('recipe.json', {
    whittle: 1,
    steps: [{ method: 'cubic' }, { method: 'cubic', lamda: 1 }],
  });
  const handles = { vertices: [999], targets: [[0, 0, 0]] };
  await desk.write('late.json', { whittle: 1, steps: [{ method: 'cubic' }, { method: 'arap', handles }] });
  const before = await desk.list();

  const said = await desk.run(line);
  expect(said).toMatchObject({ code, stdout: '', stderr: expect.stringMatching(message) });
  expect(said.stderr.trimEnd().split('\n')).toHaveLength(1);
  expect(await desk.list()).toEqual(before);
});
