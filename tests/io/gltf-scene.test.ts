import { describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { volumeInside } from '../fixtures/surfaces.ts';
import { type AnyJson, gltfBuffer, gltfJson, packGlb } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** Where a glTF scene puts its meshes, and which way round their triangles are read. */

const read = (json: AnyJson, bin = gltfBuffer()) => readMesh(packGlb(json, bin), 'a.glb');

describe('a transform that mirrors', () => {
  it.each([
    { scale: [-1, 1, 1] },
    { scale: [-2, -2, -2] },
    { rotation: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], scale: [1, 1, -4] },
    { matrix: [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1] },
  ])('turns triangles, texture coordinates with them, and no index of the file: %j', (node) => {
    const json = gltfJson();
    json.nodes[0] = { mesh: 0, ...node };
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = 4;
    // The first two numbers of each tangent serve as texture coordinates: those of one corner tell it from the others.
    json.accessors[4] = { bufferView: 0, componentType: 5126, count: 24, type: 'VEC2' };
    const { mesh } = read(json);
    expect(volumeInside(mesh)).toBeGreaterThan(0);
    const plain = read({ ...json, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] }).mesh;
    mesh.triangles.forEach((v, c) => {
      const [u, up] = [plain.positions[3 * v]!, 1 - plain.positions[3 * v + 1]!];
      expect([...mesh.uvs!.subarray(2 * c, 2 * c + 2)]).toEqual([u, up]);
    });
    const glb = packGlb(json);
    const written = writtenBytes(
      glb,
      'a.glb',
      'glb',
      mesh.positions.map((value) => 2 * value),
    );
    expect(written.subarray(-72)).toEqual(glb.subarray(-72));
  });

  it('that does so twice does not', () => {
    const json = gltfJson();
    json.nodes = [
      { mesh: 0, scale: [-1, 1, 1] },
      { children: [0], scale: [1, -1, 1] },
    ];
    const { mesh } = read(json);
    expect(volumeInside(mesh)).toBeGreaterThan(0);
    expect(mesh.triangles).toEqual(read(gltfJson()).mesh.triangles);
  });
});

/** Two cubes of the same numbers with a skin each, `nodes` being those of the scene beside the joints 2 and 3. */
function skinned(change: (json: AnyJson) => void = () => {}, binds: readonly (readonly number[])[] = []) {
  const json = gltfJson();
  json.scenes = [{ nodes: [0, 1, 2] }];
  json.nodes = [
    { mesh: 0, skin: 0 },
    { mesh: 1, skin: 1, rotation: [0, 0, 1, 1], translation: [0, 3, 0], scale: [7, 7, 7] },
    { children: [3], translation: [0, 5, 0], scale: [2, 2, 2] },
    { translation: [1, 0, 0] },
  ];
  json.meshes[1] = structuredClone(json.meshes[0]);
  json.accessors[4] = { ...json.accessors[0], bufferView: 2 };
  json.meshes[1].primitives[0].attributes = { POSITION: 4 };
  json.bufferViews[2] = { buffer: 0, byteOffset: 1032, byteLength: 960, byteStride: 40 };
  json.bufferViews[3] = { buffer: 0, byteOffset: 1992, byteLength: 64 * binds.length };
  json.skins = [{ joints: [2, 3] }, { joints: [3, 2] }];
  json.buffers = [{ byteLength: 1992 + 64 * binds.length }];
  const bin = new Uint8Array(1992 + 64 * binds.length);
  bin.set(gltfBuffer());
  bin.set(gltfBuffer().subarray(0, 960), 1032);
  const view = new DataView(bin.buffer);
  binds.flat().forEach((value, i) => {
    view.setFloat32(1992 + 4 * i, value, true);
  });
  if (binds.length > 0) {
    json.accessors[5] = { bufferView: 3, componentType: 5126, count: binds.length, type: 'MAT4' };
    for (const skin of json.skins) skin.inverseBindMatrices = 5;
  }
  change(json);
  return read(json, bin).mesh.positions;
}

describe('a skinned mesh', () => {
  const move = (x: number, y: number, z: number, s = 1) => [s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, x, y, z, 1];
  const halves = (positions: Float64Array) => [positions.subarray(0, 72), positions.subarray(72)] as const;
  const own = read({ ...gltfJson(), nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] }).mesh.positions;

  it('stands where its joints are in their bind pose, whatever its own node says', () => {
    // Inverse of joint 2's place, and of joint 3's; the second skin lists them the other way round.
    const binds = [move(0, -2.5, 0, 0.5), move(-1, -2.5, 0, 0.5)];
    const bound = skinned((json) => (json.skins[1].joints = [2, 3]), binds);
    const [first, second] = halves(bound);
    expect(first).toEqual(own);
    expect(second).toEqual(own);
  });

  it('follows one joint for all parts where the joints have moved since, so that parts that meet go on meeting', () => {
    const [first, second] = halves(
      skinned((json) => {
        json.nodes[3].rotation = [0, 0, 0.3, 1];
      }),
    );
    expect(second).toEqual(first);
    // Joint 2 says where it stands: twice as large and five up.
    expect([Math.min(...first), Math.max(...first)]).toEqual([0, 7]);
  });

  it('is taken in its own frame if its skin is broken', () => {
    for (const skin of [
      undefined,
      { joints: [99] },
      { joints: 'all' },
      { joints: [2], inverseBindMatrices: 0 },
    ]) {
      const [first] = halves(skinned((json) => (json.skins = skin ? [skin, skin] : [])));
      const isBound = skin?.joints[0] === 2;
      expect(first).toEqual(isBound ? own.map((x, i) => 2 * x + (i % 3 === 1 ? 5 : 0)) : own);
    }
  });
});
