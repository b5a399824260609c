import { describe, expect, it, test } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import {
  ascii,
  cubeObj,
  cubeOff,
  cubePlyBinary,
  cubePlyText,
  cubePositions,
  cubeStlBinary,
  cubeStlText,
  cubeTriangles,
  gltfBuffer,
  gltfJson,
  packGlb,
  text,
} from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** Files that break the rules of their format and that people have all the same: read as meant, given back as they came. */

const plainOff = `OFF\n8 12 0\n${rowsOf(cubePositions)}${rowsOf(cubeTriangles, '3 ')}`;

function rowsOf(values: readonly number[], before = ''): string {
  return values.map((value, i) => `${i % 3 === 0 ? before : ''}${value}${i % 3 === 2 ? '\n' : ' '}`).join('');
}

/** Reads the cube, moves it, and reads it again; only numbers of positions may have changed. */
function expectCube(bytes: Uint8Array, warnings: readonly unknown[] = [], extra = 0): void {
  const { mesh, format, warnings: said } = readMesh(bytes, 'cube');
  expect(said).toEqual(warnings);
  expect(mesh.triangles).toHaveLength(36);
  const corners = (positions: Float64Array, triangles: Uint32Array) =>
    [...triangles].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  const cube = cubeTriangles.flatMap((v) => cubePositions.slice(3 * v, 3 * v + 3));
  expect(corners(mesh.positions, mesh.triangles)).toEqual(cube);
  expect(writtenBytes(bytes, 'cube', format, mesh.positions)).toEqual(new Uint8Array(bytes));
  const moved = mesh.positions.map((value) => 2 * value + 1);
  const again = readMesh(writtenBytes(bytes, 'cube', format, moved), 'cube');
  const count = moved.length - 3 * extra;
  expect(again.mesh.positions.subarray(0, count)).toEqual(moved.subarray(0, count));
  expect(again.mesh.triangles).toEqual(mesh.triangles);
}

describe('OFF', () => {
  test.each([
    ['the count glued to the keyword', plainOff.replace('OFF\n', 'OFF')],
    ['everything glued', plainOff.replace('OFF\n8 12 0', 'OFF8 12')],
    ['small letters', plainOff.replace('OFF', 'off')],
    ['small letters, glued', plainOff.replace('OFF\n', 'off')],
    ['no keyword', plainOff.slice(4)],
    ['no keyword, no number of edges', plainOff.replace('OFF\n8 12 0', '# numbers\n8 12')],
    ['two vertices on a line', plainOff.replace(/^(. . .)\n(. . .)$/gm, '$1 $2')],
    ['two faces on a line', plainOff.replace(/^(3 . . .)\n(3 . . .)$/gm, '$1 $2')],
    ['two vertices on one line only', plainOff.replace('1 1 0\n', '1 1 0 ')],
    ['all on one line', plainOff.replaceAll('\n', ' ')],
    ['a number on each line', plainOff.replaceAll(' ', '\n').replace('OFF\n8\n12\n0', 'OFF\n8 12 0')],
    ['a byte order mark', `\ufeff${plainOff}`],
    ['colours that the keyword does not name', plainOff.replace(/^(. . .)$/gm, '$1 255 0 0')],
  ])('%s', (_what, source) => expectCube(ascii(source)));

  it('keeps normals apart from any dimensions in small letters', () => {
    const source = plainOff.replace(/^(. . .)$/gm, '$1  nan 0 1').replace('8 12 0  nan 0 1', '8 12 0');
    expectCube(ascii(source.replace('OFF', 'noff')));
    expect(() => readMesh(ascii(source.replace('OFF', 'nOFF')), 'a')).toThrow(/dimensions/);
  });

  it('takes the colours of vertices and faces that share lines', () => {
    const rows = plainOff.replace(/^(. . .)$/gm, '$1 255 0 0 255').replace('8 12 0 255 0 0 255', '8 12 0');
    const packed = rows.replace('OFF', 'COFF').replaceAll('0 255\n', '0 255 ');
    expectCube(ascii(packed));
    expect(readMesh(ascii(packed), 'a').mesh.colors).toEqual(
      Float32Array.from({ length: 24 }, (_, i) => (i % 3 === 0 ? 1 : 0)),
    );
  });

  it.each(['8 12\n1 2 3\n', '3 1 0\n0 0 0\n1 0 0\n0 1 0\nhello\n', '10 20 30\n11 21 31\n'])(
    'does not take any numbers for one: %j',
    (source) => expect(() => readMesh(ascii(source), 'a')).toThrow(/it is text/),
  );
});

describe('STL in text', () => {
  const stl = cubeStlText();
  test.each([
    ['end keywords in two words', stl.replace(/end(solid|loop|facet)/g, 'end $1')],
    ['end facet alone', stl.replaceAll('endfacet', 'end facet')],
    ['capitals', stl.toUpperCase().replace('SOLID', 'Solid')],
    ['capitals in two words', stl.replace(/end(solid|loop|facet)/g, 'END $1')],
    ['outer loop as one word', stl.replaceAll('outer loop', 'outerloop')],
    ['a name glued to solid', stl.replace('solid cube', 'solid_cube').replace('endsolid', 'endsolid:')],
    ['no solid', stl.replace(/^solid.*\r\n/, '')],
    ['an end without a name', stl.replace(/endsolid.*/, 'end solid')],
    ['zeros at the end', `${stl}\0\0\0\0`],
  ])('%s', (_what, source) => expectCube(ascii(source)));
});

describe('binary STL', () => {
  const odd = String.fromCharCode(...Array.from({ length: 80 }, (_, i) => 128 + i));
  const stl = (change: (view: DataView) => void, { header = 'hand', tail = 0 } = {}) => {
    const bytes = new Uint8Array(684 + tail).fill(7);
    bytes.set(cubeStlBinary());
    bytes.set(Uint8Array.from({ length: 80 }, (_, i) => header.charCodeAt(i) || 0));
    change(new DataView(bytes.buffer));
    return bytes;
  };
  const says = (count: number) => (view: DataView) => view.setUint32(80, count, true);
  const asIs = () => {};

  it('is known by its facets where the header is no text and something follows them', () => {
    for (const tail of [1, 2, 50, 100])
      expectCube(stl(asIs, { header: odd, tail }), [expect.stringContaining(`Ignored ${tail} byte`)]);
  });

  it.each([
    [0, /does not say how many facets follow, but the file holds 12/],
    [0xffffffff, /does not say/],
    [5, /counts 5 facets, but the file holds 12: all are read, and the count is right/],
    [13, /counts 13 facets.*If parts are missing, the file was cut off/],
    [1e6, /counts 1000000 facets.*cut off/],
  ])('has as many facets as its length says, not %i', (count, sentence) => {
    for (const header of ['hand', 'solid hand', odd]) {
      const bytes = stl(says(count), { header });
      const { mesh, warnings, format } = readMesh(bytes, 'a.stl');
      expect(warnings).toEqual([expect.stringMatching(sentence)]);
      expect(mesh.triangles).toHaveLength(36);
      const written = writtenBytes(bytes, 'a.stl', format, mesh.positions);
      expect(written).toEqual(stl(says(12), { header }));
      expect(readMesh(written, 'a.stl').warnings).toEqual([]);
    }
  });

  it('has the facets that were whole where the count was never filled in', () => {
    const { mesh, warnings } = readMesh(stl(says(0xffffffff), { tail: 20 }), 'a');
    expect(mesh.triangles).toHaveLength(36);
    expect(warnings).toEqual([expect.stringMatching(/does not say/), expect.stringMatching(/Ignored 20/)]);
  });

  it('is refused where it breaks off within a facet', () => {
    expect(() => readMesh(stl(says(13), { tail: 49 }), 'a')).toThrow(/promises 13 facets.*only 12/);
    expect(() => readMesh(cubeStlBinary('solid').subarray(0, 84 + 3 * 50 + 20), 'a')).toThrow(/only 3/);
  });
});

describe('PLY', () => {
  const ply = cubePlyText();
  const skipped = expect.stringMatching(/^Skipped 1 line of the PLY header .*"Created"/);

  it.each(['nan', '-nan(ind)', '1.#QNAN', '-1.#IND', 'inf'])('takes %s in normals and colours', (word) => {
    const normal = ply.replace(/^(255 0.0 0 0 128 0) \S+/m, `$1 ${word}`);
    expectCube(ascii(normal));
    const color = ply.replace(/^255 0.0 0 0/m, `${word} 0.0 0 0`);
    expectCube(ascii(color));
    const { colors } = readMesh(ascii(color), 'a').mesh;
    expect(colors!.every((value) => value >= 0 && value <= 1)).toBe(true);
  });

  it('skips what is no line of a header, in text and in bytes', () => {
    const stray = (source: string) => source.replace('element vertex', 'Created by hand\nelement vertex');
    expectCube(ascii(stray(ply)), [skipped]);
    const binary = Buffer.from(cubePlyBinary(true)).toString('latin1');
    expectCube(Uint8Array.from(Buffer.from(stray(binary), 'latin1')), [skipped]);
  });

  it.each(['propety float x', 'Property list uchar int a', 'elements face 6'])(
    'refuses a line that says something of the data: %s',
    (line) =>
      expect(() => readMesh(ascii(ply.replace('element face', `${line}\nelement face`)), 'a')).toThrow(
        /does not belong/,
      ),
  );

  it('may begin in capitals or with a byte order mark', () => {
    expectCube(ascii(ply.replace('ply', 'PLY')));
    expectCube(ascii(`\ufeff${ply}`));
  });
});

describe('text with zeros in it', () => {
  const zeros = '\0'.repeat(200);
  test.each([
    ['OBJ', cubeObj().replace('by hand', `by\0hand${zeros}`)],
    ['OBJ, in capitals', cubeObj().replace('# a', `# ${zeros}A`)],
    ['OBJ, at the end', `${cubeObj()}${zeros}`],
    ['OFF', cubeOff().replace('# colours', `# colours${zeros}`)],
    ['PLY', cubePlyText().replace('made by', `made by${zeros}`)],
  ])('%s', (_what, source) => expectCube(ascii(source)));
});

describe('a vertex that no face uses', () => {
  const said = /^(1 vertex|2 vertices) that no face uses ha(s|ve) coordinates that are no numbers; /;
  const obj = cubeObj().replace('vt 0 0', 'v 1 nan 0\nv -inf 1e999 2\nvt 0 0');
  const off = cubeOff().replace('8 6 0', '9 6 0').replace('# faces', 'NaN 0 0\n# faces');
  const ply = cubePlyText()
    .replace('vertex 8', 'vertex 9')
    .replace('3 4 0 3', '9 nan 1.#IND 0 9 9 0 0 1\n3 4 0 3');

  it.each([
    ['OBJ', obj],
    ['OFF', off],
    ['PLY', ply],
  ])('may be nowhere: %s', (_what, source) => {
    const bytes = ascii(source);
    const { mesh, format, warnings } = readMesh(bytes, 'a');
    expect(warnings).toEqual([expect.stringMatching(said)]);
    expect([...mesh.positions.subarray(24, 27)]).toEqual([0.5, 0.5, 0.5]);
    const written = text(
      writtenBytes(
        bytes,
        'a',
        format,
        mesh.positions.map((value) => value + 1),
      ),
    );
    // It keeps its very words.
    const lines = (whole: string) => whole.split('\n').filter((line) => /nan|inf/i.test(line));
    expect(lines(written)).toEqual(lines(source));
    expect(readMesh(writtenBytes(bytes, 'a', 'glb', mesh.positions), 'a').mesh.positions).toEqual(
      mesh.positions,
    );
  });

  it('may be nowhere in glTF', () => {
    const bin = gltfBuffer();
    new DataView(bin.buffer).setFloat32(4, Number.NaN, true);
    const json = gltfJson();
    json.accessors[3] = { bufferView: 1, byteOffset: 12, componentType: 5123, count: 30, type: 'SCALAR' };
    const { mesh, warnings } = readMesh(packGlb(json, bin), 'a');
    expect(warnings[0]).toMatch(said);
    expect(mesh.positions.every(Number.isFinite)).toBe(true);
    const written = writtenBytes(
      packGlb(json, bin),
      'a',
      'glb',
      mesh.positions.map((value) => value + 1),
    );
    expect(readMesh(written, 'a').warnings).toEqual(warnings);
  });

  it('is refused as soon as a face uses it', () => {
    expect(() => readMesh(ascii(`${obj}f 1 2 9\n`), 'a')).toThrow(/line \d+: the y of the vertex is "nan"/);
    expect(() => readMesh(ascii(`${off}`.replace('6 0 #', '7 0 #').concat('3 0 1 8\n')), 'a')).toThrow(
      /line \d+: the x of vertex 8 is "NaN"/,
    );
  });
});
