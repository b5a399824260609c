import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { TextScanner } from '../../src/io/text-scanner.ts';
import { ascii } from '../fixtures/tiny-files.ts';

const scan = (text: string) => new TextScanner(ascii(text), 'a.txt');

/** Expects the scanner to read the number that JavaScript reads, to the bit, −0 and 0 apart. */
function expectSame(text: string): void {
  expect(Object.is(scan(text).decimal(), Number(text)), text).toBe(true);
}

describe('decimal', () => {
  it('reads what JavaScript prints, to the bit', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (x) => expectSame(String(x))),
      {
        numRuns: 3000,
        seed: 3,
      },
    );
  });

  it('rounds decimals of any length as JavaScript does', () => {
    const digits = (max: number) => fc.stringMatching(new RegExp(`^[0-9]{0,${max}}$`));
    const exponent = fc.option(fc.integer({ min: -340, max: 330 }), { nil: undefined });
    const sign = fc.constantFrom('', '-', '+');
    fc.assert(
      fc.property(sign, digits(25), digits(25), exponent, (s, whole, fraction, e) => {
        fc.pre(whole + fraction !== '');
        expectSame(`${s}${whole}.${fraction}${e === undefined ? '' : `e${e}`}`);
      }),
      { numRuns: 5000, seed: 3 },
    );
  });

  it.each([
    '9007199254740993',
    '0.1',
    '-0',
    '1e22',
    '1e23',
    '123456789012345678e-22',
    '5e-324',
    '1E+5',
    '.5',
    '5.',
  ])('%s', expectSame);

  it.each(['', '-', '.', 'e5', '1e', '1e+', '1.2.3', '0x10', '1_000', '--1', 'Infinity', 'nan', '1,5', '1f'])(
    '%j is no number, and nothing is consumed',
    (text) => {
      const scanner = scan(text);
      expect(scanner.decimal()).toBeNaN();
      expect(scanner.at).toBe(0);
    },
  );
});

describe('lines', () => {
  it.each(['a\nb\nc', 'a\r\nb\r\nc', 'a\rb\rc'])('%j has three', (text) => {
    const scanner = scan(text);
    const starts: number[] = [];
    for (; !scanner.done; scanner.nextLine()) starts.push(scanner.at);
    expect(starts.map((at) => text[at])).toEqual(['a', 'b', 'c']);
    expect(starts.map((at) => scanner.lineAt(at))).toEqual([1, 2, 3]);
  });

  it('go on behind a backslash, but not inside a comment', () => {
    const scanner = scan('1 \\\r\n 2 # 3 \\\n4');
    expect([scanner.numberInLine('x'), scanner.numberInLine('y')]).toEqual([1, 2]);
    expect(scanner.peekInLine()).toBe(10);
    expect(scanner.number('z')).toBe(4);
  });
});
