import { describe, expect, test } from 'vitest';
import {
  diagonalOf,
  duration,
  farthest,
  markdownTable,
  median,
  percent,
  quantile,
  times,
  withSpread,
} from './numbers.ts';
import { comparedMethods, faceCounts, methods, parseOptions, sizes } from './options.ts';
import { type Descent, type Measurement, meshOf, type Reshaping, type Timing } from './program.ts';
import { report } from './report.ts';
import { reportAlone } from './report-alone.ts';
import { reportReshaping } from './report-reshape.ts';

describe('numbers of the benchmark', () => {
  test('quantiles lie between the values', () => {
    expect(median([5, 1, 3])).toBe(3);
    expect(median([4, 1, 2, 3])).toBe(2.5);
    expect(quantile([10, 20], 0.25)).toBe(12.5);
    expect(quantile([7], 0.9)).toBe(7);
    expect(withSpread([0.5, 1, 1.5, 2, 2.5])).toBe('1.50 (1.00–2.00)');
  });

  test('distances are those of the farthest point and of the corners of the box', () => {
    const points = Float64Array.of(0, 0, 0, 3, 4, 0, 1, 1, 1);
    expect(farthest(points, Float64Array.of(0, 0, 0, 3, 2, 0, 1, 1, 2))).toBe(2);
    expect(diagonalOf(points)).toBe(Math.hypot(3, 4, 1));
  });

  test('are written for people', () => {
    expect(times(4.2)).toBe('4.2×');
    expect(times(23.4)).toBe('23×');
    expect(times(-0.1)).toBe('–');
    expect(times(1 / 0)).toBe('–');
    expect(percent(0.01245)).toBe('1.2 %');
    expect(percent(0)).toBe('0 %');
    expect(percent(3e-7)).toBe('< 0.001 %');
    expect(percent(-1)).toBe('–');
    expect(duration(0.6591)).toBe('0.66 ms');
    expect(duration(412.9)).toBe('410 ms');
    expect(duration(2820)).toBe('2.8 s');
    expect(duration(-1)).toBe('–');
  });

  test('stand in aligned tables', () => {
    expect(markdownTable(['a', 'build'], [['12345', 'wasm']])).toBe(
      '| a     | build |\n| ----- | ----- |\n| 12345 | wasm  |',
    );
  });
});

describe('arguments of the benchmark', () => {
  test('choose methods and sizes', () => {
    expect(parseOptions([])).toEqual({ methods, sizes, faceCounts, write: false });
    expect(parseOptions(['--quick', '--write'])).toEqual({
      methods,
      sizes: [2562, 22046],
      faceCounts: [2000, 8500, 22000],
      write: true,
    });
    expect(parseOptions(['cubic', '22046'])).toMatchObject({ methods: ['cubic'], sizes: [22046] });
    expect(parseOptions(['reshape', '8500'])).toMatchObject({ methods: ['reshape'], faceCounts: [8500] });
  });

  test('a reference is timed on few sizes unless some are named', () => {
    expect(parseOptions(['--against', 'main'])).toMatchObject({
      against: 'main',
      methods: comparedMethods,
      sizes: [2562, 22046],
    });
    expect(() => parseOptions(['polycube', '--against', 'main'])).toThrowError(/cubic, analogy, arap only/);
    expect(parseOptions(['10242', '--against', 'HEAD~1']).sizes).toEqual([10242]);
  });

  test.each([[['cubist']], [['--against']], [['123']], [['--write', '--against', 'main']]])(
    '%j is refused with the usage',
    (args) => {
      expect(() => parseOptions(args)).toThrowError(/usage: npm run bench/);
    },
  );

  test('every size has its mesh', () => {
    for (const size of sizes.filter((vertices) => vertices < 50_000))
      expect(meshOf(size).positions.length / 3).toBe(size);
  });
});

describe('report of the benchmark', () => {
  const compare = (plain: number, ours: number) => ({ ours, plain, ratio: plain / ours });
  const run: Descent = {
    iterations: 208,
    time: 1500,
    rested: 1,
    aboveLowest: 0,
    toPercent: { iterations: 18, time: 200 },
    toPermille: { iterations: 36, time: 100 },
    stop: { iterations: 58, time: 150, aboveLowest: 8e-5 },
  };
  const never = { iterations: -1, time: -1 };
  const plain: Descent = {
    ...run,
    rested: 0,
    toPercent: never,
    toPermille: never,
    stop: { iterations: 111, time: 2500, aboveLowest: 0.0124 },
  };
  const measurement: Measurement = {
    vertices: 22046,
    compiler: 'a compiler',
    memory: 22046 * 1024,
    lowest: 1,
    energyAtFixedCount: 1.04,
    cold: run,
    warm: run,
    plain,
    phases: {
      prepare: { whole: compare(90, 30), order: compare(12, 12), factor: compare(25, 10) },
      iteration: { whole: compare(30, 2), solve: compare(3, 1), rest: compare(27, 1) },
    },
  };

  test('says how many times as fast, which bars are met and what was never reached', () => {
    const text = report('cubic', [{ native: measurement, wasm: measurement }]);
    expect(text).toContain(
      '| 22046    | wasm   | 1.0×  | 2.5×   | 3.0×    | 27×   | 3.0×  | 15×       | 500',
    );
    expect(text).toMatch(/\| solve +\| 4× +\| 3\.0× +\| no/);
    // Its time was up, 1.5 s, before it got there; ours was there after 100 ms.
    expect(text).toMatch(/within 0\.1 %.*\| 20× +\| > 15× +\| no/);
    expect(text).toContain('> 208 / > 208');
    expect(text).toContain('> 1.5 s');
    expect(text).toContain('22 MB, 1.00 KB');
  });

  test('times the plain path to where it got', () => {
    const slow = { ...plain, toPermille: { iterations: 320, time: 9000 } };
    const text = report('cubic', [{ native: measurement, wasm: { ...measurement, plain: slow } }]);
    expect(text).toMatch(/within 0\.1 %.*\| 20× +\| 90× +\| yes/);
  });

  test('marks numbers whose E* is not known for sure', () => {
    const unrested = { ...measurement, cold: { ...run, rested: 0 } };
    const text = report('arap', [{ native: unrested, wasm: unrested }]);
    expect(text).toContain('≈ 18 / 36');
    expect(text).toContain('208 (time was up)');
    expect(text).not.toContain('Bars');
  });
});

test('of a method without a plain path the report has its own times, and how far the builds are apart', () => {
  const alone = {
    fresh: 120,
    warm: 60,
    iteration: 5,
    iterations: 40,
    finished: 1,
    time: 200,
    firstEnergy: 0.5,
    lastEnergy: 0.25,
    energyAtFixedCount: 0.3,
  };
  const native: Timing = { vertices: 2562, compiler: 'a compiler', memory: 2562 * 2048, alone };
  const wasm: Timing = {
    ...native,
    alone: { ...alone, iteration: 6, finished: 0, energyAtFixedCount: 0.3003 },
  };
  const lines = reportAlone('polycube', [{ native, wasm }]).split('\n');
  const rowOf = (build: string) => lines.find((line) => line.split('|')[2]?.trim() === build)!;
  expect(rowOf('native')).toMatch(/200 +\| 40 in 200 ms +\| 0.5000 → 0.2500 +\| 5 MB, 2.00 KB/);
  expect(rowOf('wasm')).toMatch(/40 in 200 ms \(time was up\).*\| 1.20 +\| 1.0e-3/);
});

describe('report of reshaping', () => {
  const run = { name: 'plate', faces: 8400, ready: 100, first: 150, final: 700, iterations: 6 };
  const wasm: Reshaping = {
    compiler: 'a compiler',
    cold: { ...run, final: 900 },
    memory: 8400 * 4096,
    runs: [run, { ...run, name: 'ball', final: 2600 }, { ...run, name: 'bracket', final: 600 }],
    compared: {
      iteration: { ours: 50, plain: 1500, ratio: 30 },
      plainIterations: 5,
      plainTime: 7500,
      plainFinished: 0,
    },
    solvers: {
      direct: { prepare: 340, solve: 14 },
      gradients: { prepare: 8, solve: 23 },
      blocks: { prepare: 14, solve: 12, iterations: 7 },
      means: { prepare: 4, solve: 3 },
    },
  };

  test('says which bars are met, and how the plain path does', () => {
    const text = reportReshaping([{ native: wasm, wasm }]);
    expect(text).toMatch(/median to the final result \| ≤ 800 ms \| 700 ms +\| yes/);
    expect(text).toMatch(/8\.5K faces, worst +\| ≤ 2\.5 s +\| 2\.6 s +\| no/);
    expect(text).toMatch(/8400 +\| wasm +\| 50 ms +\| 1\.5 s +\| 30× +\| 5 in 7\.5 s \(time was up\)/);
    expect(text).toContain('33 MB, 4.00 KB');
    expect(text).not.toContain('84K');
  });

  test('leaves out what large meshes do not have', () => {
    const { compared: _, solvers: __, ...large } = { ...wasm, cold: { ...run, faces: 84_400 } };
    const text = reportReshaping([{ native: large, wasm: large }]);
    expect(text).toContain('84K faces, first picture');
    expect(text).not.toContain('plain Eigen');
  });
});
