import { describe, expect, it } from 'vitest';
import { fileNameEndings, formatForFileName, formats, readMesh } from '../../src/io/index.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { allCubes, cubePositions } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** Twice the positions that `Math.fround` keeps, moved a little: exact in 32 bits. */
const moved = (positions: Float64Array) => positions.map((value, i) => 1.5 * value + (i % 3) * 0.25 + 0.125);

/** Six times the enclosed volume: tells winding, missing and doubled faces. */
function volume({ positions: x, triangles }: Mesh): number {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    sum += x[a] * (x[b + 1] * x[c + 2] - x[b + 2] * x[c + 1]);
    sum += x[a + 1] * (x[b + 2] * x[c] - x[b] * x[c + 2]);
    sum += x[a + 2] * (x[b] * x[c + 1] - x[b + 1] * x[c]);
  }
  return sum;
}

describe.each(allCubes())('$name ($format)', ({ name, format, bytes }) => {
  const read = readMesh(bytes, name);
  const size = format === 'glb' || format === 'gltf' ? 2 : 1;

  it('is recognised by its bytes and is a cube', () => {
    expect(read.format).toBe(format);
    expect(read.warnings).toEqual([]);
    expect(read.mesh.triangles).toHaveLength(36);
    expect(volume(read.mesh)).toBeCloseTo(6 * size ** 3, 12);
  });

  it('comes back byte for byte with its own positions', () => {
    expect(writtenBytes(bytes, name, format, read.mesh.positions)).toEqual(bytes);
  });

  it('comes back with the positions that were put in', () => {
    const positions = moved(read.mesh.positions);
    const written = writtenBytes(bytes, name, format, positions);
    const again = readMesh(written, name);
    expect(again.mesh.positions).toEqual(positions);
    expect(again.mesh.triangles).toEqual(read.mesh.triangles);
    expect(again.mesh.colors).toEqual(read.mesh.colors);
    // And back: only the numbers' spelling may differ.
    const back = readMesh(writtenBytes(written, name, format, read.mesh.positions), name);
    expect(back.mesh.positions).toEqual(read.mesh.positions);
  });

  it('does not change the source and works on a Buffer and on a window of a larger one', () => {
    const large = Buffer.alloc(bytes.length + 7, 65);
    large.set(bytes, 3);
    const window = large.subarray(3, 3 + bytes.length);
    const positions = moved(read.mesh.positions);
    expect(writtenBytes(window, name, format, positions)).toEqual(
      writtenBytes(bytes, name, format, positions),
    );
    expect(new Uint8Array(window)).toEqual(bytes);
  });

  it.each(formats.map(({ id }) => id).filter((other) => other !== format))('becomes %s', (other) => {
    const positions = moved(read.mesh.positions);
    const written = writtenBytes(bytes, name, other, positions);
    const again = readMesh(written, name);
    expect(again.format).toBe(other);
    expect(again.warnings).toEqual([]);
    expect(again.mesh.triangles).toHaveLength(36);
    expect(volume(again.mesh)).toBeCloseTo(6 * 1.5 ** 3 * size ** 3, 10);
  });

  it('refuses another number of positions and what is not finite', () => {
    expect(() => writtenBytes(bytes, name, format, new Float64Array(3))).toThrow(
      expect.objectContaining({ code: 'bad-parameter', message: expect.stringContaining(name) }),
    );
    const positions = read.mesh.positions.slice();
    positions[7] = Number.NaN;
    expect(() => writtenBytes(bytes, name, format, positions)).toThrow(
      expect.objectContaining({
        code: 'not-finite',
        message: expect.stringContaining('vertex 2'),
        element: 2,
      }),
    );
  });
});

describe('other formats', () => {
  const obj = allCubes()[0];
  const positions = readMesh(obj.bytes, 'cube.obj').mesh.positions;

  it.each(['ply-ascii', 'ply-binary', 'off'] as const)('%s keeps quads, order and colours', (format) => {
    const source = readMesh(obj.bytes, 'cube.obj').mesh;
    const { mesh } = readMesh(writtenBytes(obj.bytes, 'cube.obj', format, positions), 'x');
    expect(Array.from(mesh.positions)).toEqual(cubePositions);
    expect(mesh.triangles).toEqual(source.triangles);
    for (let i = 0; i < 24; i++) expect(mesh.colors![i]).toBeCloseTo(source.colors![i], 2);
  });

  it('joins the corners of an STL', () => {
    const stl = allCubes()[3];
    const corners = readMesh(stl.bytes, 'x').mesh.positions;
    expect(corners).toHaveLength(108);
    expect(readMesh(writtenBytes(stl.bytes, 'x', 'obj', corners), 'x').mesh.positions).toHaveLength(24);
  });

  it('writes numbers that read back exactly', () => {
    const odd = positions.map((_, i) => Math.PI ** (i - 12) * (i % 2 ? -1 : 1));
    for (const format of ['obj', 'ply-ascii', 'ply-binary', 'off'] as const) {
      const written = writtenBytes(obj.bytes, 'cube.obj', format, odd);
      expect(readMesh(written, 'x').mesh.positions).toEqual(odd);
    }
  });

  it('refuses numbers that 32 bits cannot hold', () => {
    const huge = positions.map((value) => value * 1e300);
    expect(() => writtenBytes(obj.bytes, 'cube.obj', 'glb', huge)).toThrow(/^cube\.obj, vertex 1: /);
    expect(readMesh(writtenBytes(obj.bytes, 'cube.obj', 'ply-binary', huge), 'x').mesh.positions).toEqual(
      huge,
    );
    const float = allCubes()[7];
    expect(() => writtenBytes(float.bytes, 'cube.ply', 'ply-binary', huge)).toThrow(
      expect.objectContaining({ code: 'not-finite' }),
    );
  });
});

describe('file names', () => {
  it('have a format each', () => {
    expect(fileNameEndings.map((ending) => formatForFileName(`A.b${ending.toUpperCase()}`))).toEqual([
      'obj',
      'glb',
      'gltf',
      'stl-binary',
      'ply-binary',
      '3mf',
      'off',
    ]);
  });

  it('keep the flavour of the source', () => {
    expect(formatForFileName('a.stl', 'stl-ascii')).toBe('stl-ascii');
    expect(formatForFileName('a.ply', 'stl-ascii')).toBe('ply-binary');
  });

  it.each(['cube.fbx', 'cube', 'cube.constructor', ''])('%j is refused with the list', (name) => {
    expect(() => formatForFileName(name)).toThrow(
      expect.objectContaining({ code: 'unknown-format', message: expect.stringContaining('.glb') }),
    );
  });
});
