import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { type FailureCode, WhittleError } from '../../src/mesh/failure.ts';
import {
  type AnyJson,
  ascii,
  cubeObj,
  cubeOff,
  cubePlyBinary,
  cubePlyText,
  cubeStlBinary,
  cubeStlText,
  gltfBuffer,
  gltfJson,
  packGlb,
  packGltf,
  plyHeader,
} from '../fixtures/tiny-files.ts';

/** A file, the code of its refusal, and what the sentence must name. */
type Case = readonly [what: string, bytes: Uint8Array, code: FailureCode, says: RegExp];

const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
const utf16 = (source: string, swap = false) => {
  const bytes = Buffer.from(source, 'utf16le');
  return new Uint8Array(swap ? bytes.swap16() : bytes);
};
const thrownBy = (act: () => unknown): unknown => {
  try {
    act();
  } catch (thrown) {
    return thrown;
  }
  return undefined;
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
const glb = (change: (json: AnyJson) => unknown, bin = gltfBuffer()) => {
  const json = gltfJson();
  change(json);
  return packGlb(json, bin);
};

const anyFile: Case[] = [
  ['nothing', new Uint8Array(), 'empty-file', /^file\.obj: it is empty/],
  ['blanks', ascii(' \r\n\t\n'), 'empty-file', /no content/],
  ['comments', ascii('# only\n# comments\n'), 'empty-file', /but comments/],
  ['prose', ascii('Dear reader,\nthis is a letter.\n'), 'unknown-format', /text.*\.glb/],
  ['random bytes', noise(5000), 'unknown-format', /\.obj, \.stl/],
  ['few random bytes', noise(7), 'unknown-format', /\.obj, \.stl/],
  ['a web page', ascii('<!DOCTYPE html><html><body>404</body></html>'), 'unknown-format', /web page/],
  ['UTF-16 with a mark', utf16(`\ufeff${cubeObj()}`), 'unsupported-file', /UTF-16.*UTF-8/],
  ['UTF-16 without', utf16(cubeObj()), 'unsupported-file', /UTF-16/],
  ['UTF-16, big end first', utf16(cubeObj(), true), 'unsupported-file', /UTF-16/],
  ['gzip', gzipSync(cubeObj()), 'unsupported-file', /gzip; unpack/],
  ['zip', ascii('PK\u0003\u0004rest'), 'unsupported-file', /zip/],
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
  ['NaN', ascii(`# head\r\n\r\nv 0 nan 0\r\n`), 'not-finite', /line 3: the y of the vertex is "nan"/],
  ['-inf', ascii('v -inf 0 0\n'), 'not-finite', /line 1: the x/],
  ['Windows’ NaN', ascii('v 1.#IND 0 0\n'), 'not-finite', /line 1/],
  ['an overflow', ascii('v 0 0 1e999\n'), 'not-finite', /line 1: the z.*"1e999"/],
  ['a decimal comma', ascii('v 0,5 1 2\n'), 'malformed-file', /line 1: .*"0,5".*point/],
  ['a word as number', ascii('v 0 1 x2\n'), 'malformed-file', /"x2", not a number/],
  ['points only', ascii(triangle), 'no-faces', /3 points but no faces/],
  ['edges only', ascii(`${triangle}f 1 2\n`), 'no-faces', /no faces/],
  ['faces only', ascii('f 1 2 3\n'), 'index-out-of-range', /line 1: .*the file has none/],
];

const stlFiles: Case[] = [
  [
    'four billion facets',
    stl((view) => view.setUint32(80, 0xffffffff, true)),
    'truncated-file',
    /4294967295 facets.*only 12/,
  ],
  [
    'the same that says solid',
    stl((view) => view.setUint32(80, 0xffffffff, true), 'solid'),
    'truncated-file',
    /4294967295/,
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
  ['a stray line', ascii('ply\nformat ascii 1.0\nhello\n'), 'malformed-file', /line 3: "hello"/],
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
  ['NaN', ascii(ply.replace('255 1.0 0 0', '255 1.0 nan 0')), 'not-finite', /line 25: /],
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

const deep = 300000;
const gltfFiles: Case[] = [
  ['GLB, cut', packGlb(gltfJson()).subarray(0, 900), 'truncated-file', /byte 900: /],
  ['GLB, only the magic', ascii('glTF'), 'truncated-file', /byte 4: /],
  ['GLB, version 1', glb(() => 0).fill(1, 4, 5), 'unsupported-file', /version 1/],
  ['GLB, text renamed', ascii('glTF is a format'), 'truncated-file', /byte 16/],
  ['glTF 1', ascii('{"asset":{"version":"1.0"}}'), 'unsupported-file', /asset: .*1\.0/],
  ['JSON, cut', packGltf(gltfJson()).subarray(0, 300), 'truncated-file', /JSON: /],
  ['JSON, broken', ascii('{"asset":,}'), 'malformed-file', /JSON: /],
  ['JSON with NaN', ascii('{"asset":{"version":"2.0"},"scene":NaN}'), 'malformed-file', /JSON: /],
  ['JSON, deep and cut', ascii('{"a":'.repeat(deep)), 'truncated-file', /JSON: /],
  ['JSON, deep', ascii(`{"a":${'['.repeat(deep)}${']'.repeat(deep)}}`), 'no-faces', /no triangles/],
  [
    'an accessor beyond its view',
    glb((j) => {
      j.accessors[0].count = 25;
    }),
    'truncated-file',
    /accessor 0: .*byte 972 .* 960/,
  ],
  [
    'a view beyond its buffer',
    glb((j) => {
      j.bufferViews[1].byteLength = 9999;
    }),
    'truncated-file',
    /buffer view 1: .*10959 .* 1032/,
  ],
  [
    'a buffer beyond the file',
    glb((j) => {
      j.buffers[0].byteLength = 1e12;
    }),
    'truncated-file',
    /buffer 0: .*only 1032/,
  ],
  [
    'a count below 0',
    glb((j) => {
      j.accessors[0].count = -1;
    }),
    'malformed-file',
    /accessor 0: -1/,
  ],
  [
    'a count that is a text',
    glb((j) => {
      j.accessors[0].count = 'many';
    }),
    'malformed-file',
    /accessor 0: many/,
  ],
  [
    'an offset below 0',
    glb((j) => {
      j.bufferViews[0].byteOffset = -4;
    }),
    'malformed-file',
    /buffer view 0: -4/,
  ],
  [
    'a missing accessor',
    glb((j) => {
      j.meshes[0].primitives[0].attributes.POSITION = 17;
    }),
    'index-out-of-range',
    /mesh 0, primitive 0: .*accessors\[17\]/,
  ],
  [
    'a missing mesh',
    glb((j) => {
      j.nodes[0].mesh = 3;
    }),
    'index-out-of-range',
    /node 0: .*meshes\[3\]/,
  ],
  [
    'a missing node',
    glb((j) => {
      j.scenes[0].nodes = [9];
    }),
    'index-out-of-range',
    /scene: .*nodes\[9\]/,
  ],
  [
    'a ring of nodes',
    glb((j) => {
      j.nodes[0].children = [1];
    }),
    'malformed-file',
    /node 1: .*twice/,
  ],
  [
    'a matrix with holes',
    glb((j) => {
      j.nodes[0].matrix = [1, 2, null];
    }),
    'malformed-file',
    /node 0: 16 finite/,
  ],
  [
    'meshes that are none',
    glb((j) => {
      j.meshes = 'none';
    }),
    'malformed-file',
    /meshes: /,
  ],
  [
    'a mesh that is null',
    glb((j) => {
      j.meshes = [null];
    }),
    'malformed-file',
    /meshes\[0\]: /,
  ],
  [
    'nothing in the scene',
    glb((j) => {
      j.scenes[0].nodes = [];
    }),
    'no-faces',
    /no triangles/,
  ],
  [
    'a cloud of points',
    glb((j) => {
      j.meshes[0].primitives[0].mode = 0;
    }),
    'no-faces',
    /no triangles/,
  ],
  [
    'a mode that is none',
    glb((j) => {
      j.meshes[0].primitives[0].mode = 7;
    }),
    'malformed-file',
    /mode 7/,
  ],
  [
    'an external buffer',
    glb((j) => {
      j.buffers[0].uri = 'cube.bin';
    }),
    'unsupported-file',
    /buffer 0: .*"cube\.bin".*\.glb/,
  ],
  [
    'bad base64',
    glb((j) => {
      j.buffers[0].uri = 'data:;base64,@@@@';
    }),
    'malformed-file',
    /buffer 0: .*base64/,
  ],
  [
    'Draco',
    glb((j) => {
      j.meshes[0].primitives[0].extensions = { KHR_draco_mesh_compression: {} };
    }),
    'unsupported-file',
    /primitive 0: .*Draco/,
  ],
  [
    'meshopt',
    glb((j) => {
      j.bufferViews[0].extensions = { EXT_meshopt_compression: {} };
    }),
    'unsupported-file',
    /buffer view 0: .*meshopt/,
  ],
  [
    'an index too large',
    glb(() => 0, gltfBuffer().fill(24, 960, 961)),
    'index-out-of-range',
    /accessor 3: .*vertex 24.* 24/,
  ],
  ['NaN', glb(() => 0, gltfBuffer().fill(255, 80, 84)), 'not-finite', /accessor 0: vertex 2 .*NaN/],
  [
    'zeros without end',
    glb((j) => {
      j.accessors[0] = { componentType: 5126, count: 1e12, type: 'VEC3' };
    }),
    'too-large',
    /accessor 0: /,
  ],
  [
    'one list of indices, used without end',
    glb((j) => {
      j.accessors[3].count = 60000;
      j.bufferViews[1].byteLength = 120000;
      j.buffers[0].byteLength = 120960;
      j.meshes[0].primitives = new Array(20000).fill({ attributes: { POSITION: 0 }, indices: 3 });
    }, new Uint8Array(120960)),
    'too-large',
    /primitive \d+: |accessor 3: /,
  ],
  [
    'a sparse index too large',
    glb((j) => {
      const indices = { bufferView: 1, byteOffset: 2, componentType: 5123 };
      j.accessors[0].sparse = { count: 3, indices, values: { bufferView: 0 } };
      j.accessors[0].count = 2;
    }),
    'index-out-of-range',
    /accessor 0 \(sparse\): .*element 2 of 2/,
  ],
];

describe.each([
  ['any file', anyFile],
  ['OBJ', obj],
  ['STL', stlFiles],
  ['PLY', plyFiles],
  ['OFF', offFiles],
  ['glTF', gltfFiles],
])('%s is refused with one sentence:', (_, cases) => {
  it.each(cases)('%s', (_what, bytes, code, says) => {
    const start = performance.now();
    const failure = thrownBy(() => readMesh(bytes, 'file.obj'));
    expect(performance.now() - start).toBeLessThan(2000);
    expect(failure).toBeInstanceOf(WhittleError);
    expect(failure).toMatchObject({ code, message: expect.stringMatching(says) });
    expect((failure as Error).message).toMatch(/^file\.obj[:,] [^\n]+\.$/);
  });
});

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
