import { describe } from 'vitest';
import { type Case, itRefuses } from '../fixtures/refusals.ts';
import { type AnyJson, ascii, gltfBuffer, gltfJson, packGlb, packGltf } from '../fixtures/tiny-files.ts';

const glb = (change: (json: AnyJson) => unknown, bin = gltfBuffer()) => {
  const json = gltfJson();
  change(json);
  return packGlb(json, bin);
};
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
    /buffer 0: .*"cube\.bin", which is not there; open both together/,
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

describe('glTF is refused with one sentence:', () => itRefuses(gltfFiles));
