import { expect, test } from 'vitest';
import { emptyHistory, record } from '../../src/editor/history.ts';
import { keptBytes } from '../../src/editor/kept-bytes.ts';
import type { Project } from '../../src/editor/project.ts';
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
  expect(keptBytes(history.past)).toBeLessThanOrEqual(256 * 2 ** 20);
  expect(history.past.length).toBeGreaterThan(25);
  expect(history.past.at(-1)!.after).toBe(before);
});
