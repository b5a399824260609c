import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import { ProgressGate } from '../../src/engine/progress-gate.ts';
import type { Iterating, Progress, SolveSettings } from '../../src/engine/protocol.ts';
import { FakeCore, fakeServices, tetrahedron } from './fake-core.ts';

let engine: Engine;
let core: FakeCore;
beforeEach(() => {
  core = new FakeCore({ stepMilliseconds: 1 });
  engine = createEngine({ spawn: () => spawnInProcess(fakeServices(core)) });
});
afterEach(() => engine.dispose());

function settings(maxIterations: number, positions: boolean): SolveSettings {
  return { method: 'cubic', parameters: { maxIterations, tolerance: 0 }, start: 'rest', positions };
}

/** Keeps what a run says while it iterates. */
function kept(list: Iterating[]): (progress: Progress) => void {
  return (progress) => {
    if (progress.kind === 'iterating') list.push(structuredClone(progress));
  };
}

test('progress shows positions in file order and together holds every iteration once', async () => {
  const seen: Iterating[] = [];
  const solved = await engine.solve(tetrahedron(), settings(60, true), { onProgress: kept(seen) });
  expect(seen.length).toBeGreaterThan(2);
  const shown = seen.flatMap(({ energy }) => energy);
  expect(shown).toEqual(solved.energy.slice(0, shown.length));
  for (const { iteration, positions, change } of seen) {
    expect(positions?.[3]).toBeCloseTo(4 + 4 * 0.5 ** iteration, 12);
    expect(positions?.slice(6, 9)).toEqual(positions?.slice(0, 3));
    expect(change.at(-1)).toBeCloseTo(4 * 0.5 ** (iteration - 1), 12);
  }
});

test('a page that draws slowly gets less progress and does not slow the run', async () => {
  let drawing = 0;
  let atOnce = 0;
  let seen = 0;
  const onProgress = async () => {
    seen++;
    atOnce = Math.max(atOnce, ++drawing);
    await new Promise((resolve) => setTimeout(resolve, 50));
    drawing--;
  };
  const solved = await engine.solve(tetrahedron(), settings(120, true), { onProgress });
  expect(atOnce).toBe(1);
  expect(seen).toBeGreaterThan(1);
  expect(seen).toBeLessThanOrEqual(solved.milliseconds.solve / 50 + 2);
  // A run that waited for the page would have shown it each of its 120 iterations.
  expect(seen).toBeLessThan(60);
});

test('a page that never draws gets progress once', async () => {
  let seen = 0;
  const onProgress = () => {
    seen++;
    return new Promise<void>(() => {});
  };
  const solved = await engine.solve(tetrahedron(), settings(50, true), { onProgress });
  expect(solved.iterations).toBe(50);
  expect(seen).toBe(1);
});

test('progress without positions comes at most every 100 ms', async () => {
  const seen: Iterating[] = [];
  const solved = await engine.solve(tetrahedron(), settings(350, false), { onProgress: kept(seen) });
  expect(seen.length).toBeGreaterThanOrEqual(2);
  expect(seen.length).toBeLessThanOrEqual(solved.milliseconds.solve / 100 + 1);
  expect(seen.every(({ positions }) => positions === undefined)).toBe(true);
});

test('the buffer that comes back is filled again', () => {
  const posted: Iterating[] = [];
  const given: (Float64Array | undefined)[] = [];
  const copyPositions = (into?: Float64Array<ArrayBuffer>) => {
    given.push(into);
    return into ?? new Float64Array(3);
  };
  const gate = new ProgressGate(
    { withPositions: true, copyPositions, post: (now) => posted.push(now as Iterating) },
    0,
  );
  const step = (energy: number) => ({ outcome: 'running' as const, energy, change: 1 });
  gate.add(1, step(5), 0);
  gate.add(2, step(4), 1);
  gate.add(3, step(3), 2);
  expect(posted).toHaveLength(1);
  const buffer = posted[0]!.positions!;
  gate.seen(buffer);
  gate.add(4, step(2), 3);
  expect(posted[1]).toMatchObject({ iteration: 4, energy: [4, 3, 2] });
  expect(posted[1]!.positions).toBe(buffer);
  expect(given).toEqual([undefined, buffer]);
});

describe('preparing in stages', () => {
  const slow = { prepareMilliseconds: 30, prepareStages: 8 };
  const restart = () => {
    core = new FakeCore(slow);
    engine = createEngine({ spawn: () => spawnInProcess(fakeServices(core)) });
  };

  test('says what is being done and how far it is', async () => {
    restart();
    const stages: [string, number][] = [];
    await engine.solve(tetrahedron(), settings(1, false), {
      onProgress: (progress) => {
        if (progress.kind === 'preparing') stages.push([progress.stage, progress.share]);
      },
    });
    expect(stages.length).toBeGreaterThan(0);
    for (const [stage, share] of stages) expect(stage).toBe(`stage ${Math.round(8 * share)}`);
  });

  test('is cancelled between two stages, and the run keeps what the mesh has', async () => {
    restart();
    const stop = new AbortController();
    const solving = engine.solve(tetrahedron(), settings(9, false), {
      signal: stop.signal,
      onProgress: () => stop.abort(),
    });
    expect(await solving).toMatchObject({ outcome: 'cancelled', iterations: 0 });
    expect(core.log.filter((call) => call === 'prepare').length).toBeLessThan(8);
    expect(core.steps).toBe(0);
  });

  test('is overtaken by a newer run, but not twice before a step was made', async () => {
    restart();
    const mesh = tetrahedron();
    const runs: ReturnType<Engine['solve']>[] = [];
    const begin = (): void => {
      // Each run is overtaken as soon as it prepares.
      const onProgress = () => {
        if (runs.length < 4) begin();
      };
      runs.push(engine.solve(mesh, settings(1000, false), { onProgress }));
    };
    begin();
    const solved = [];
    for (let k = 0; k < runs.length; k++) solved.push(await runs[k]!);
    expect(solved.map(({ outcome }) => outcome).slice(0, -1)).toEqual([
      'cancelled',
      'cancelled',
      'cancelled',
    ]);
    expect(solved[0]!.iterations).toBe(0);
    expect(solved[1]!.iterations).toBeGreaterThan(0);
  });
});

test('a field of the latest run comes in the file’s order', async () => {
  const mesh = tetrahedron();
  const { fields } = await engine.solve(mesh, settings(3, false));
  expect(fields.map(({ name }) => name)).toEqual(['height', 'creases']);
  const heights = await engine.field(mesh, 'height');
  expect(heights).toHaveLength(5);
  expect(heights[0]).toBe(heights[2]);
  // Lines come by positions of the file, two for each: the second place of a seam is not named.
  expect([...(await engine.field(mesh, 'creases'))]).toEqual([0, 1, 3, 4]);
  await expect(engine.field(mesh, 'depth')).rejects.toThrow('There is no field “depth” to show.');
});
