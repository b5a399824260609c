import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Format, readMesh } from '../../src/io/index.ts';
import { failureCodes, WhittleError } from '../../src/mesh/failure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { allCubes, ascii } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** One damage to a file: bytes changed, cut, doubled, or put in. */
interface Damage {
  readonly kind: 'set' | 'flip' | 'cut' | 'double' | 'insert' | 'end';
  readonly at: number;
  readonly length: number;
  readonly byte: number;
}

const damage: fc.Arbitrary<Damage> = fc.record({
  kind: fc.constantFrom('set', 'flip', 'cut', 'double', 'insert', 'end'),
  at: fc.double({ min: 0, max: 1, noNaN: true, maxExcluded: true }),
  length: fc.integer({ min: 1, max: 40 }),
  // Digits, signs, blanks and letters of keywords break text files more cleverly than random bytes do.
  byte: fc.oneof(
    fc.integer({ min: 0, max: 255 }),
    fc.constantFrom(...ascii('0123456789-+.eE/ \n\r\t#\\fvn"[]{}:,')),
  ),
});

function apply(bytes: Uint8Array, { kind, at, length, byte }: Damage): Uint8Array {
  const begin = Math.floor(at * bytes.length);
  const head = bytes.subarray(0, begin);
  const piece = bytes.subarray(begin, begin + length);
  const tail = bytes.subarray(begin + piece.length);
  switch (kind) {
    case 'set':
      return Uint8Array.of(...head, byte, ...bytes.subarray(begin + 1));
    case 'flip':
      return bytes.map((value, i) => (i === begin ? value ^ (1 << (byte & 7)) : value));
    case 'cut':
      return Uint8Array.of(...head, ...tail);
    case 'double':
      return Uint8Array.of(...head, ...piece, ...piece, ...tail);
    case 'insert':
      return Uint8Array.of(...head, ...new Uint8Array(length & 7).fill(byte), ...piece, ...tail);
    case 'end':
      return head;
  }
}

/** The very bytes; but the count of a binary STL is right in what is given back. */
function asGivenBack(bytes: Uint8Array, format: Format, { triangles }: Mesh): Uint8Array {
  const result = new Uint8Array(bytes);
  if (format === 'stl-binary') new DataView(result.buffer).setUint32(80, triangles.length / 3, true);
  return result;
}

/** A mesh that is whole, or an error of ours; and in the first case the file can be given back. */
function readsOrRefuses(bytes: Uint8Array): void {
  const before = process.cpuUsage();
  try {
    const { mesh, format } = readMesh(bytes, 'fuzz');
    const count = mesh.positions.length / 3;
    expect(mesh.triangles.length).toBeGreaterThan(0);
    expect(mesh.triangles.length % 3).toBe(0);
    expect(mesh.triangles.every((index) => index < count)).toBe(true);
    expect(mesh.positions.every(Number.isFinite)).toBe(true);
    expect(mesh.colors?.every((value) => value >= 0 && value <= 1) ?? true).toBe(true);
    expect(mesh.colors?.length ?? mesh.positions.length).toBe(mesh.positions.length);
    expect(writtenBytes(bytes, 'fuzz', format, mesh.positions)).toEqual(asGivenBack(bytes, format, mesh));
    const moved = mesh.positions.map((value) => Math.fround(value / 2 + 1));
    const again = readMesh(writtenBytes(bytes, 'fuzz', format, moved), 'again');
    expect(again.format).toBe(format);
    expect(again.mesh.triangles).toHaveLength(mesh.triangles.length);
  } catch (thrown) {
    if (!(thrown instanceof WhittleError)) throw thrown;
    expect(failureCodes).toContain(thrown.code);
    expect(thrown.code).not.toBe('internal');
    expect(thrown.message).toMatch(/^(fuzz|again)[:,] [^\n]+\.$/);
    expect(thrown.message).not.toMatch(/^again.*(truncated|cut off)/);
  }
  // Time of the processor, not of the clock: the machine may be busy with something else.
  expect(process.cpuUsage(before).user).toBeLessThan(1_000_000);
}

describe('damaged files are read or refused, nothing else', () => {
  it.each(allCubes())(
    '$name ($format)',
    ({ bytes }) => {
      fc.assert(
        fc.property(fc.array(damage, { minLength: 1, maxLength: 4 }), (damages) => {
          readsOrRefuses(damages.reduce(apply, bytes as Uint8Array));
        }),
        { numRuns: 400, seed: 20240 },
      );
    },
    60000,
  );

  it('random bytes, alone and behind every beginning', () => {
    const beginnings = [
      '',
      'glTF',
      'solid ',
      'ply\n',
      'OFF ',
      'v ',
      '{"',
      'ply\nformat ascii 1.0\n',
      'f 1 2 3\nv ',
    ];
    fc.assert(
      fc.property(fc.constantFrom(...beginnings), fc.uint8Array({ maxLength: 400 }), (beginning, bytes) => {
        readsOrRefuses(Uint8Array.of(...ascii(beginning), ...bytes));
      }),
      { numRuns: 2000, seed: 20240 },
    );
  }, 60000);

  it('JSON of any shape', () => {
    const keys = [
      'nodes',
      'scenes',
      'meshes',
      'accessors',
      'bufferViews',
      'buffers',
      'scene',
      'asset',
      'count',
    ];
    fc.assert(
      fc.property(fc.dictionary(fc.constantFrom(...keys), fc.jsonValue({ maxDepth: 4 })), (json) => {
        readsOrRefuses(ascii(JSON.stringify(json)));
      }),
      { numRuns: 1000, seed: 20240 },
    );
  });

  it('glTF with any member set to anything', () => {
    const glb = allCubes().find(({ format }) => format === 'gltf')!;
    const source = new TextDecoder().decode(glb.bytes);
    const numbers = [...source.matchAll(/(?<=: )(-?\d+|"VEC3"|\[[^\]]*\])/g)];
    const junk = fc.oneof(
      fc.integer({ min: -2, max: 40 }),
      fc.double(),
      fc.constantFrom(2 ** 31, 2 ** 32, 2 ** 53, 1e300, null, '', [], [0], {}, true),
    );
    fc.assert(
      fc.property(fc.nat(numbers.length - 1), junk, (which, value) => {
        const { index, 0: found } = numbers[which];
        const text = source.slice(0, index) + JSON.stringify(value) + source.slice(index + found.length);
        readsOrRefuses(ascii(text));
      }),
      { numRuns: 1500, seed: 20240 },
    );
  }, 60000);
});
