import { describe, expect, test } from 'vitest';
import { fileNameEndings } from '../../src/io/index.ts';
import { methods } from '../../src/methods/registry.ts';
import { commands } from './commands.ts';
import { compare } from './compare.ts';
import type { Result } from './trees.ts';

describe('the command lines that are compared', () => {
  test('are of every method, and of recipes', () => {
    const used = new Set(commands.map(([line]) => line.split(' ')[0]));
    expect([...used].sort()).toEqual([...methods.map(({ id }) => id), 'run'].sort());
  });

  test('read and write every format that is one file', () => {
    const wanted = fileNameEndings.filter((ending) => ending !== '.gltf');
    const read = commands.map(([line]) => /\w(\.\w+)(?: --|$)/.exec(line)![1]);
    expect([...new Set(read)].sort()).toEqual([...wanted].sort());
    expect([...new Set(commands.map(([, ending]) => `.${ending}`))].sort()).toEqual([...wanted].sort());
  });
});

describe('two results', () => {
  const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  const result = (file: string, energy: number[] = [2, 1]): Result => ({
    file: Buffer.from(file),
    steps: [{ method: 'cubic', iterations: energy.length, outcome: 'converged', energy }],
  });

  test('are the same if every byte and every energy is', () => {
    expect(compare(result(text), result(text))).toEqual({});
  });

  test('differ by a byte, and it says where and how far', () => {
    const moved = text.replace('v 1 0 0', 'v 3 0 0');
    expect(compare(result(text), result(moved))).toEqual({
      file: 'differs from byte 10 on, positions by 2.0e+0',
    });
    expect(compare(result(text), result(`${text}# more\n`)).file).toMatch(/^differs from byte 32 on/);
    expect(compare(result(text), result('nothing')).file).toBe('differs from byte 0 on');
  });

  test('differ by the last bit of an energy, or by the number of iterations', () => {
    expect(compare(result(text), result(text, [2, 1 + Number.EPSILON]))).toEqual({
      energy: 'differs from iteration 2 of step 1 on',
    });
    expect(compare(result(text), result(text, [2, 1, 0])).energy).toBe(
      'cubic converged after 2 → cubic converged after 3',
    );
  });
});
