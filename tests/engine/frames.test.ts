import { afterEach, beforeEach, expect, test } from 'vitest';
import { createEngine, type Engine } from '../../src/engine/client.ts';
import { FrameGate } from '../../src/engine/frames.ts';
import { spawnInProcess } from '../../src/engine/in-process.ts';
import type { Frame, SolveSettings } from '../../src/engine/protocol.ts';
import { FakeCore, fakeServices, tetrahedron } from './fake-core.ts';

let engine: Engine;
let core: FakeCore;
beforeEach(() => {
  core = new FakeCore({ stepMilliseconds: 1 });
  engine = createEngine({ spawn: () => spawnInProcess(fakeServices(core)) });
});
afterEach(() => engine.dispose());

function settings(maxIterations: number, frames: boolean): SolveSettings {
  return { method: 'cubic', parameters: { maxIterations, tolerance: 0 }, start: 'rest', frames };
}

test('frames show positions in file order and together hold every iteration once', async () => {
  const frames: Frame[] = [];
  const solved = await engine.solve(tetrahedron(), settings(60, true), {
    onFrame: (frame) => void frames.push(structuredClone(frame)),
  });
  expect(frames.length).toBeGreaterThan(2);
  const shown = frames.flatMap(({ energy }) => energy);
  expect(shown).toEqual(solved.energy.slice(0, shown.length));
  for (const { iteration, positions, change } of frames) {
    expect(positions?.[3]).toBeCloseTo(4 + 4 * 0.5 ** iteration, 12);
    expect(positions?.slice(6, 9)).toEqual(positions?.slice(0, 3));
    expect(change.at(-1)).toBeCloseTo(4 * 0.5 ** (iteration - 1), 12);
  }
});

test('a page that draws slowly gets fewer frames and does not slow the run', async () => {
  let drawing = 0;
  let atOnce = 0;
  let seen = 0;
  const onFrame = async () => {
    seen++;
    atOnce = Math.max(atOnce, ++drawing);
    await new Promise((resolve) => setTimeout(resolve, 50));
    drawing--;
  };
  const solved = await engine.solve(tetrahedron(), settings(120, true), { onFrame });
  expect(atOnce).toBe(1);
  expect(seen).toBeGreaterThan(1);
  expect(seen).toBeLessThanOrEqual(solved.milliseconds.solve / 50 + 2);
  // A run that waited for the page would have shown it each of its 120 iterations.
  expect(seen).toBeLessThan(60);
});

test('a page that never draws gets one frame', async () => {
  let seen = 0;
  const onFrame = () => {
    seen++;
    return new Promise<void>(() => {});
  };
  const solved = await engine.solve(tetrahedron(), settings(50, true), { onFrame });
  expect(solved.iterations).toBe(50);
  expect(seen).toBe(1);
});

test('progress without positions comes at most every 100 ms', async () => {
  const frames: Frame[] = [];
  const solved = await engine.solve(tetrahedron(), settings(350, false), {
    onFrame: (frame) => void frames.push(frame),
  });
  expect(frames.length).toBeGreaterThanOrEqual(2);
  expect(frames.length).toBeLessThanOrEqual(solved.milliseconds.solve / 100 + 1);
  expect(frames.every(({ positions }) => positions === undefined)).toBe(true);
});

test('the buffer that comes back is filled again', () => {
  const posted: Frame[] = [];
  const given: (Float64Array | undefined)[] = [];
  const copyPositions = (into?: Float64Array<ArrayBuffer>) => {
    given.push(into);
    return into ?? new Float64Array(3);
  };
  const gate = new FrameGate({ withPositions: true, copyPositions, post: (frame) => posted.push(frame) }, 0);
  const step = (energy: number) => ({ outcome: 'running' as const, energy, change: 1 });
  gate.add(1, step(5), 0);
  gate.add(2, step(4), 1);
  gate.add(3, step(3), 2);
  expect(posted).toHaveLength(1);
  const buffer = posted[0]!.positions!;
  gate.drawn(buffer);
  gate.add(4, step(2), 3);
  expect(posted[1]).toMatchObject({ iteration: 4, energy: [4, 3, 2] });
  expect(posted[1]!.positions).toBe(buffer);
  expect(given).toEqual([undefined, buffer]);
});
