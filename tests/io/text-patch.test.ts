import { describe, expect, it } from 'vitest';
import { type Format, readMesh } from '../../src/io/index.ts';
import { ascii, cubeObj, cubeOff, cubePlyText, cubeStlText, text } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** Writes with a few coordinates changed: {index into the flat positions: value}. */
function patched(source: string, format: Format, changes: Readonly<Record<number, number>>): string {
  const bytes = ascii(source);
  const positions = readMesh(bytes, 'source').mesh.positions.slice();
  for (const [i, value] of Object.entries(changes)) positions[Number(i)] = value;
  return text(writtenBytes(bytes, 'source', format, positions));
}

/** Lines that differ, as [before, after]. Fails if the number of lines does. */
function changedLines(before: string, after: string): [string, string][] {
  const a = before.split('\n');
  const b = after.split('\n');
  expect(b).toHaveLength(a.length);
  return a.map((line, i): [string, string] => [line, b[i]]).filter(([left, right]) => left !== right);
}

describe('OBJ', () => {
  it('rewrites only the numbers that changed, and the normals of faces that moved', () => {
    const source = cubeObj('\r\n');
    // The top corner 6 = (1, 1, 1) goes up: the sides stay planes, so only the top turns.
    const lines = changedLines(source, patched(source, 'obj', { 20: 2 }));
    expect(lines).toEqual([
      ['v  1.0\t1.00 1 0.6000000000000001 0.5 0.25\r', 'v  1.0\t1.00 2 0.6000000000000001 0.5 0.25\r'],
      ['vn 0.0000 0.0000 1.0000\r', 'vn -0.408248 -0.408248 0.816497\r'],
    ]);
  });

  it('keeps line continuations, comments behind numbers, weights and a missing last line end', () => {
    const source = 'v 0 0 \\\n 0 0.5 # w\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2\\\n 3 # face';
    expect(patched(source, 'obj', { 2: 5, 4: 7 })).toBe(
      source.replace('\\\n 0 ', '\\\n 5 ').replace('v 1 0', 'v 1 7'),
    );
  });

  it('keeps a byte order mark and what is not UTF-8', () => {
    const source = ascii('\ufeffv 0 0 0\nv 1 0 0\nv 0 1 0\ng na_e\nf 1 2 3\n');
    source[source.indexOf(95)] = 0xe9;
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 3, 0);
    const expected = source.slice();
    expected[source.lastIndexOf(49, source.indexOf(103))] = 51;
    expect(writtenBytes(source, 'x', 'obj', positions)).toEqual(expected);
  });

  it('leaves the normals of a region that has not moved, however odd they are', () => {
    const island = (z: number) => `v 0 0 ${z}\nv 1 0 ${z}\nv 0 1 ${z}\n`;
    const source = `${island(0)}${island(5)}vn .6 .8 0.0\nvn 0 0 7\nf 1//1 2//1 3//1\nf -3//2 -2//2 -1//2\n`;
    expect(changedLines(source, patched(source, 'obj', { 17: 6 }))).toEqual([
      ['v 0 1 5', 'v 0 1 6'],
      ['vn 0 0 7', 'vn 0 -0.707107 0.707107'],
    ]);
  });

  it('survives normals that do not exist or are not numbers', () => {
    const source = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 x\nf 1//1 2//9 3//-7\n';
    expect(patched(source, 'obj', { 8: 1 })).toBe(
      source.replace('v 0 1 0', 'v 0 1 1').replace('nan 0 x', '0 -0.707107 0.707107'),
    );
  });
});

describe('STL in text', () => {
  it('rewrites vertices and the normals of their facets', () => {
    const source = cubeStlText();
    const lines = changedLines(source, patched(source, 'stl-ascii', { 2: -1 }));
    expect(lines).toEqual([
      [
        '  facet normal 0.000000e+0 0.000000e+0 -1.000000e+0\r',
        '  facet normal 0.000000e+0 0.707107 -0.707107\r',
      ],
      ['      vertex 0 0 0\r', '      vertex 0 0 -1\r'],
    ]);
  });

  it('keeps normals of zero, several solids, capitals and names that look like keywords', () => {
    const facet = 'FACET NORMAL 0 0 0 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET\n';
    const source = `solid vertex facet\n${facet}endsolid\nsolid\n${facet}endsolid facet normal`;
    const result = patched(source, 'stl-ascii', { 17: 4 });
    expect(changedLines(source, result)).toEqual([[facet.trim(), facet.trim().replace('0 1 0', '0 1 4')]]);
  });
});

describe('PLY in text', () => {
  it('rewrites positions among other properties', () => {
    const source = cubePlyText();
    const lines = changedLines(source, patched(source, 'ply-ascii', { 18: 1.5, 19: 1.5, 20: 1.5 }));
    const positions = lines.filter(([before, after]) => before.split(' ')[1] !== after.split(' ')[1]);
    expect(positions).toHaveLength(1);
    expect(positions[0][1]).toMatch(
      /^255 1\.5 1\.5 1\.5 128 0 0\.577350258\d+ 0\.577350258\d+ 0\.577350258\d+$/,
    );
    // Its own normal keeps its direction, hence its text. Six others share a face with it and turn.
    expect(lines).toHaveLength(7);
  });

  it('turns whole numbers into decimal ones only when they change', () => {
    const source =
      'ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty  uchar y\nproperty int z\n' +
      'element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
    expect(patched(source, 'ply-ascii', {})).toBe(source);
    const header = source
      .replace('int x', 'float x')
      .replace('uchar y', 'float y')
      .replace('int z', 'float z');
    expect(patched(source, 'ply-ascii', { 0: 0.5 })).toBe(header.replace('\n0 0 0', '\n0.5 0 0'));
    const large = source.replace('1 0 0', '3000000 0 0');
    expect(patched(large, 'ply-ascii', { 3: 3000000.25 })).toBe(
      header.replaceAll('float', 'double').replace('1 0 0', '3000000.25 0 0'),
    );
  });

  it('finds positions behind lists of any length', () => {
    const source =
      'ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int near\nproperty float x\n' +
      'property list int float w\nproperty float y\nproperty float z\nelement face 1\n' +
      'property list uchar int vertex_index\nend_header\n2 7 9 0 0 0 0\n0 1 1 5.5 0 0\n1 8 0 2 1 1 1 0\n3 0 1 2\n';
    expect(patched(source, 'ply-ascii', { 0: 4, 4: 3, 8: 2 })).toBe(
      source
        .replace('2 7 9 0 0 0 0', '2 7 9 4 0 0 0')
        .replace('0 1 1 5.5 0 0', '0 1 1 5.5 3 0')
        .replace('1 8 0 2 1 1 1 0', '1 8 0 2 1 1 1 2'),
    );
  });
});

describe('OFF', () => {
  it('rewrites positions and keeps colours and comments', () => {
    const source = cubeOff();
    expect(changedLines(source, patched(source, 'off', { 3: 2.5 }))).toEqual([
      ['1.0 0 0  255 0 0 255', '2.5 0 0  255 0 0 255'],
    ]);
  });

  it('rewrites normals of NOFF', () => {
    const source = 'NOFF 3 1 0\n0 0 0  0 0 1\n1 0 0  0 0 1\n0 1 0  0 0 1\n3 0 1 2';
    expect(patched(source, 'off', { 2: 1, 5: 1, 8: 2 })).toBe(
      'NOFF 3 1 0\n0 0 1  0 -0.707107 0.707107\n1 0 1  0 -0.707107 0.707107\n0 1 2  0 -0.707107 0.707107\n3 0 1 2',
    );
  });
});
