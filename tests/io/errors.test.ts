import { gzipSync } from 'node:zlib';
import { zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { type Case, itRefuses } from '../fixtures/refusals.ts';
import {
  ascii,
  cubeObj,
  cubeOff,
  cubePlyBinary,
  cubePlyText,
  cubeStlBinary,
  cubeStlText,
  plyHeader,
} from '../fixtures/tiny-files.ts';

const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
const utf16 = (source: string, swap = false) => {
  const bytes = Buffer.from(source, 'utf16le');
  return new Uint8Array(swap ? bytes.swap16() : bytes);
};
/** Bytes that are the same every time and look like nothing. */
const noise = (length: number) => {
  let state = 12345;
  return new Uint8Array(length).map(() => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    return state >>> 16;
  });
};
const stl = (change: (view: DataView) => void, header?: string) => {
  const bytes = cubeStlBinary(header);
  change(new DataView(bytes.buffer));
  return bytes;
};

const anyFile: Case[] = [
  ['nothing', new Uint8Array(), 'empty-file', /^file\.obj: it is empty/],
  ['blanks', ascii(' \r\n\t\n'), 'empty-file', /no content/],
  ['comments', ascii('# only\n# comments\n'), 'empty-file', /but comments/],
  ['prose', ascii('Dear reader,\nthis is a letter.\n'), 'unknown-format', /text.*\.glb/],
  ['random bytes', noise(5000), 'unknown-format', /\.obj, \.glb/],
  ['few random bytes', noise(7), 'unknown-format', /\.obj, \.glb/],
  ['a web page', ascii('<!DOCTYPE html><html><body>404</body></html>'), 'unknown-format', /web page/],
  ['UTF-16 with a mark', utf16(`\ufeff${cubeObj()}`), 'unsupported-file', /UTF-16.*UTF-8/],
  ['UTF-16 without', utf16(cubeObj()), 'unsupported-file', /UTF-16/],
  ['UTF-16, big end first', utf16(cubeObj(), true), 'unsupported-file', /UTF-16/],
  ['gzip', gzipSync(cubeObj()), 'unsupported-file', /gzip; unpack/],
  ['zip', zipSync({ 'a.obj': ascii(cubeObj()) }), 'unsupported-file', /zip archive; unpack/],
  ['a broken zip', ascii('PK\u0003\u0004rest'), 'truncated-file', /archive is broken/],
  ['FBX', ascii('Kaydara FBX Binary  \0'), 'unsupported-file', /FBX.*\.glb/],
  ['a picture', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10), 'unsupported-file', /picture/],
];

const obj: Case[] = [
  [
    'faces cut off from their vertices',
    ascii(`f 1 2 3\n${triangle}f 1 2 9041\n`),
    'index-out-of-range',
    /^file\.obj, line 5: .*9041.* 3;/,
  ],
  ['a face cut in the middle', ascii(`${triangle}f 1 2`), 'truncated-file', /line 4.*middle of a face/],
  [
    'a vertex cut in the middle',
    ascii(`${triangle}f 1 2 3\nv 1 2`),
    'truncated-file',
    /line 5.*ends before the z/,
  ],
  ['a short vertex', ascii('v 1 2\nf 1 1 1\n'), 'malformed-file', /line 1: the line ends before the z/],
  ['index 0', ascii(`${triangle}f 0 1 2\n`), 'index-out-of-range', /line 4: .*vertex 0.*from 1/],
  [
    'an index before the first',
    ascii(`${triangle}f -1 -2 -4\n`),
    'index-out-of-range',
    /line 4: .*-4.*only 3/,
  ],
  ['a huge index', ascii(`${triangle}f 1 2 99999999999999999999\n`), 'index-out-of-range', /line 4/],
  ['a fraction as index', ascii(`${triangle}f 1 2 2.5\n`), 'malformed-file', /line 4: .*"\.5"/],
  ['a word as index', ascii(`${triangle}f 1 two 3\n`), 'malformed-file', /line 4: .*"two"/],
  ['NaN', ascii(`# head\r\n\r\nv 0 nan 0\r\nf 1 1 1`), 'not-finite', /line 3: the y of the vertex is "nan"/],
  ['-inf', ascii('v -inf 0 0\nf 1 1 1\n'), 'not-finite', /line 1: the x/],
  ['Windows’ NaN', ascii('v 1.#IND 0 0\nf 1 1 1\n'), 'not-finite', /line 1/],
  ['an overflow', ascii('v 0 0 1e999\nf 1 1 1\n'), 'not-finite', /line 1: the z.*"1e999"/],
  ['a decimal comma', ascii('v 0,5 1 2\n'), 'malformed-file', /line 1: .*"0,5".*point/],
  ['a word as number', ascii('v 0 1 x2\n'), 'malformed-file', /"x2", not a number/],
  ['points only', ascii(triangle), 'no-faces', /3 points but no faces/],
  ['edges only', ascii(`${triangle}f 1 2\n`), 'no-faces', /no faces/],
  ['faces only', ascii('f 1 2 3\n'), 'index-out-of-range', /line 1: .*the file has none/],
];

const stlFiles: Case[] = [
  [
    'no count, and no facets',
    stl((view) => {
      view.setUint32(80, 0xffffffff, true);
      view.setFloat32(84 + 12, 1e30, true);
    }),
    'truncated-file',
    /4294967295 facets.*only 12/,
  ],
  ['binary, cut', cubeStlBinary().subarray(0, 300), 'truncated-file', /byte 300: .*12 facets.*only 4/],
  [
    'binary, NaN',
    stl((view) => view.setFloat32(84 + 50 * 3 + 12, Number.NaN, true)),
    'not-finite',
    /facet 4: .*NaN/,
  ],
  ['binary, none', stl((view) => view.setUint32(80, 0, true)).subarray(0, 84), 'no-faces', /no facets/],
  ['text, cut', ascii(cubeStlText().slice(0, 250)), 'truncated-file', /line \d+: /],
  ['text, no facets', ascii('solid a\nendsolid a\n'), 'no-faces', /no mesh/],
  [
    'text, two corners',
    ascii('solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 1 1\nendfacet\n'),
    'malformed-file',
    /line 5: .*three/,
  ],
  ['text, nonsense', ascii('solid\nfacet normal 0 0 1\nouter hoop\n'), 'malformed-file', /line 3: .*"hoop"/],
  ['text, no normal', ascii('solid\nfacet 0 0 1\n'), 'malformed-file', /line 2: .*normal/],
  [
    'text, facet in facet',
    ascii('solid\nfacet normal 0 0 1\nfacet normal 0 0 1\n'),
    'malformed-file',
    /line 3/,
  ],
  ['text, stray vertex', ascii('solid\nvertex 0 0 1\n'), 'malformed-file', /line 2/],
  ['text, stray endfacet', ascii('solid\nendfacet\n'), 'malformed-file', /line 2/],
  [
    'text, infinite',
    ascii('solid\nfacet normal 0 0 1\nvertex 0 Infinity 0\n'),
    'not-finite',
    /line 3: the y/,
  ],
];

const ply = cubePlyText();
const plyFiles: Case[] = [
  [
    'too many vertices',
    ascii(ply.replace('vertex 8', 'vertex 4000000000')),
    'truncated-file',
    /4000000000 "vertex" elements/,
  ],
  ['too many faces', ascii(ply.replace('face 6', 'face 99999')), 'truncated-file', /99999 "face" elements/],
  [
    'one face too many',
    ascii(ply.replace('face 6', 'face 7').replace('edge 1', 'edge 0')),
    'truncated-file',
    /line \d+: /,
  ],
  ['a count that is none', ascii(ply.replace('vertex 8', 'vertex -8')), 'malformed-file', /line 7: .*"-8"/],
  ['no end_header', ascii(ply.slice(0, 200)), 'truncated-file', /end_header/],
  ['no format', ascii('ply\nelement vertex 1\nend_header\n'), 'malformed-file', /line 3: .*format/],
  ['another format', ascii('ply\nformat base64 1.0\n'), 'malformed-file', /line 2: "base64"/],
  [
    'another type',
    ascii('ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n'),
    'malformed-file',
    /line 4: "quad"/,
  ],
  ['a property of nothing', ascii('ply\nformat ascii 1.0\nproperty int x\n'), 'malformed-file', /line 3/],
  [
    'a misspelt element',
    ascii('ply\nformat ascii 1.0\nelment vertex 8\n'),
    'malformed-file',
    /line 3: "elment"/,
  ],
  [
    'vertices without z',
    ascii(ply.replace('property float z', 'property float w')),
    'malformed-file',
    /header: .*x, y and z/,
  ],
  [
    'faces without corners',
    ascii(ply.replace('vertex_indices', 'things')),
    'malformed-file',
    /vertex indices/,
  ],
  [
    'points only',
    ascii(
      `${plyHeader('ascii').replace('face 6', 'face 0')}2 7 -8 0.5\n${'0 0 0 0 0 0 0 0 0\n'.repeat(8)}1\n`,
    ),
    'no-faces',
    /8 points/,
  ],
  ['NaN', ascii(ply.replace('255 1.0 0 0', '255 1.0 nan 0')), 'not-finite', /vertex 1: a coordinate is NaN/],
  [
    'an index too large',
    ascii(ply.replace('4 4 5 6 7', '4 4 5 6 8')),
    'index-out-of-range',
    /face 1: .*vertex 8.* 7;/,
  ],
  [
    'an index below 0',
    ascii(ply.replace('4 4 5 6 7', '4 4 5 6 -1')),
    'index-out-of-range',
    /face 1: .*vertex -1/,
  ],
  [
    'an endless list',
    ascii(ply.replace('4 4 5 6 7', '4000000000 4 5 6 7')),
    'truncated-file',
    /line 33: .*4000000000 values/,
  ],
  ['a list of length -4', ascii(ply.replace('4 4 5 6 7', '-4 4 5 6 7')), 'malformed-file', /line 33: .*-4/],
  ['cut, little end first', cubePlyBinary(true).subarray(0, -40), 'truncated-file', /byte \d+: /],
  ['cut, big end first', cubePlyBinary(false).subarray(0, 500), 'truncated-file', /header: |byte \d+: /],
];

const off = cubeOff();
const offFiles: Case[] = [
  ['too many vertices', ascii(off.replace('8 6 0', '4000000000 6 0')), 'truncated-file', /line 3|line 4/],
  ['a count that is none', ascii(off.replace('8 6 0', '8 -6 0')), 'malformed-file', /line 3: .*-6/],
  [
    'an index too large',
    ascii(off.replace('4  4 5 6 7', '4  4 5 6 8')),
    'index-out-of-range',
    /line 14: .*vertex 8/,
  ],
  [
    'an index below 0',
    ascii(off.replace('4  4 5 6 7', '4  4 5 6 -7')),
    'index-out-of-range',
    /line 14: .*-7/,
  ],
  ['an endless face', ascii(off.replace('4  4 5 6 7', '999999999  4 5 6 7')), 'truncated-file', /line 14: /],
  ['NaN', ascii(off.replace('1.0 0 0 ', '1.0 NaN 0 ')), 'not-finite', /line 5: the y of vertex 1/],
  ['cut', ascii(off.slice(0, -40)), 'truncated-file', /line 1[78]: /],
  ['binary', ascii('OFF BINARY\n'), 'unsupported-file', /line 1: binary/],
  ['four dimensions', ascii('4OFF\n'), 'unsupported-file', /line 1: .*dimensions/],
  ['points only', ascii('OFF\n2 0 0\n0 0 0\n1 1 1\n'), 'no-faces', /2 points/],
];

describe.each([
  ['any file', anyFile],
  ['OBJ', obj],
  ['STL', stlFiles],
  ['PLY', plyFiles],
  ['OFF', offFiles],
])('%s is refused with one sentence:', (_, cases) => itRefuses(cases));

describe('small faults are mended and told', () => {
  it('skips faces of two corners', () => {
    const { mesh, warnings } = readMesh(ascii(`${triangle}f 1 2\nf 1 2 3\nf 1\n`), 'a.obj');
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2]);
    expect(warnings).toEqual([expect.stringMatching(/2 faces.*line 4/)]);
  });

  it('keeps faces that repeat a vertex', () => {
    const { mesh } = readMesh(ascii(`${triangle}f 1 2 2\nf 1 2 3 3\n`), 'a.obj');
    expect(mesh.triangles).toHaveLength(9);
  });

  it('tells of a missing endsolid and of bytes behind an STL', () => {
    const cut = cubeStlText().replace(/endsolid.*/, '');
    expect(readMesh(ascii(cut), 'a.stl').warnings).toEqual([expect.stringContaining('endsolid')]);
    const long = new Uint8Array(84 + 600 + 3);
    long.set(cubeStlBinary());
    expect(readMesh(long, 'a.stl').warnings).toEqual([expect.stringContaining('3 bytes')]);
  });
});
