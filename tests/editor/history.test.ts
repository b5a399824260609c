import { expect, test } from 'vitest';
import { emptyHistory, type History, record, redo, undo } from '../../src/editor/history.ts';
import { keptBytes } from '../../src/editor/kept-bytes.ts';
import type { Project, Result } from '../../src/editor/project.ts';
import { newStep } from '../../src/editor/steps.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';

test('every buffer and list counts, each once however often it is reached', () => {
  const positions = new Float64Array(100);
  expect(keptBytes({ a: positions, b: [{ again: positions }] }, new Map([['x', positions]]))).toBe(800);
  expect(keptBytes({ half: positions.subarray(50) })).toBe(800);
  expect(keptBytes({ list: [1, 2, 3], text: 'abcd' })).toBe(32);
  const loop: Record<string, unknown> = {};
  loop.self = loop;
  expect(keptBytes(loop)).toBe(0);
});

test('a hundred strokes of a field of 8 MB stay inside the budget, the newest of them', () => {
  const mesh = tetrahedron();
  const stroke = (fill: number): Project => ({
    source: { bytes: new Uint8Array(8), name: 'a.obj', format: 'obj' },
    mesh,
    report: {} as never,
    steps: [
      newStep({ method: 'cubic', parameters: { lambdaPerVertex: new Float64Array(2 ** 20).fill(fill) } }),
    ],
    active: 1,
    assets: new Map(),
    groups: [],
  });
  let history = emptyHistory;
  let before = stroke(0);
  for (let k = 1; k <= 100; k++) {
    const after = stroke(k);
    history = record(history, { label: `Stroke ${k}`, before, after });
    before = after;
  }
  expect(keptBytes(history)).toBeLessThanOrEqual(256 * 2 ** 20);
  expect(history.past.length + history.farPast.length).toBeGreaterThan(25);
  expect(history.past.at(-1)!.after).toBe(before);
});

/** A mesh as large as one of half a million faces, of which undo sees nothing but the positions. */
const large = { positions: new Float64Array(3 * 250_000), triangles: new Uint32Array(3 * 500_000) };

function shifted(by: number): Float64Array {
  const positions = new Float64Array(large.positions.length);
  for (let i = 0; i < positions.length; i++) positions[i] = by * ((i % 199) - 99) * 0.01;
  return positions;
}

/** What a stroke over some thousand vertices leaves: a field, and a shape that is a little other everywhere. */
function afterStroke(before: Project, stroke: number): Project {
  const step = before.steps[0]!;
  const field = (step.parameters.lambdaPerVertex as Float64Array).slice();
  for (let k = 0; k < 4000; k++) field[(stroke * 2000 + k) % field.length] = 0.1 * stroke + k / 3;
  const parameters = { ...step.parameters, lambdaPerVertex: field };
  const result = {
    positions: shifted(0.002 * stroke),
    state: 'settled',
    fields: [],
    of: { from: large.positions, method: step.method, parameters, assets: [] },
    resolved: parameters,
  } as unknown as Result;
  return { ...before, steps: [{ ...step, parameters, result }] };
}

/** Where two lists begin to differ, −1 where they do not: half a million numbers are told apart in a moment. */
function firstDifference(a: unknown, b: unknown): number {
  const [one, other] = [a as Float64Array, b as Float64Array];
  return one.length === other.length ? one.findIndex((value, k) => !Object.is(value, other[k])) : -2;
}

test('a hundred strokes on half a million faces stay inside the budget, and all are undone and redone', () => {
  const parameters = { lambda: 0.3, lambdaPerVertex: new Float64Array(250_000) };
  let project: Project = {
    source: { bytes: new Uint8Array(20 * 2 ** 20), name: 'a.obj', format: 'obj' },
    mesh: large,
    report: {} as never,
    steps: [newStep({ method: 'cubic', parameters })],
    active: 1,
    assets: new Map(),
    groups: [],
  };
  let history: History = emptyHistory;
  const fields: unknown[] = [];
  const samples: number[] = [];
  for (let k = 1; k <= 100; k++) {
    const after = afterStroke(project, k);
    history = record(history, { label: `Stroke ${k}`, before: project, after });
    fields.push(after.steps[0]!.parameters.lambdaPerVertex);
    samples.push(after.steps[0]!.result!.positions[12_345]!);
    project = after;
  }
  const isInside = () => keptBytes(history) <= 256 * 2 ** 20;
  expect(isInside()).toBe(true);
  for (let k = 100; k >= 1; k--) {
    const undone = undo(history)!;
    expect(undone.entry.label).toBe(`Stroke ${k}`);
    history = undone.history;
    project = undone.entry.before;
    if (k === 1) break;
    const { parameters: now, result } = project.steps[0]!;
    if (k % 9 === 0) expect(firstDifference(now.lambdaPerVertex, fields[k - 2])).toBe(-1);
    expect(Math.abs(result!.positions[12_345]! - samples[k - 2]!)).toBeLessThan(0.4 / 32767);
    expect(result!.of.from).toBe(large.positions);
    expect(result!.of.parameters).toBe(now);
  }
  expect(undo(history)).toBeNull();
  expect(firstDifference(project.steps[0]!.parameters.lambdaPerVertex, parameters.lambdaPerVertex)).toBe(-1);
  expect(project.steps[0]!.parameters.lambda).toBe(0.3);
  expect(isInside()).toBe(true);
  for (let k = 1; k <= 100; k++) {
    const again = redo(history)!;
    history = again.history;
    project = again.entry.after;
    expect(again.entry.label).toBe(`Stroke ${k}`);
  }
  expect(firstDifference(project.steps[0]!.parameters.lambdaPerVertex, fields[99])).toBe(-1);
  expect(redo(history)).toBeNull();
  expect(isInside()).toBe(true);
});
