import { describe, expect, test } from 'vitest';
import {
  duration,
  markdownTable,
  median,
  percent,
  quantile,
  times,
  withSpread,
} from '../benchmarks/numbers.ts';
import { methods, parseOptions, sizes } from '../benchmarks/options.ts';
import { meshOf } from '../benchmarks/program.ts';

describe('numbers of the benchmark', () => {
  test('quantiles lie between the values', () => {
    expect(median([5, 1, 3])).toBe(3);
    expect(median([4, 1, 2, 3])).toBe(2.5);
    expect(quantile([10, 20], 0.25)).toBe(12.5);
    expect(quantile([7], 0.9)).toBe(7);
    expect(withSpread([0.5, 1, 1.5, 2, 2.5])).toBe('1.50 (1.00–2.00)');
  });

  test('are written for people', () => {
    expect(times(31.5, 7.5)).toBe('4.2×');
    expect(times(234, 10)).toBe('23×');
    expect(times(-1, 10)).toBe('–');
    expect(times(1, 0)).toBe('–');
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
    expect(parseOptions([])).toEqual({ methods, sizes, write: false });
    expect(parseOptions(['--quick', '--write'])).toEqual({ methods, sizes: [2562, 22046], write: true });
    expect(parseOptions(['cubic', '22046'])).toEqual({ methods: ['cubic'], sizes: [22046], write: false });
  });

  test('a reference is timed on few sizes unless some are named', () => {
    expect(parseOptions(['--against', 'main'])).toMatchObject({ against: 'main', sizes: [2562, 22046] });
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
