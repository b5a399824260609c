import { describe, expect, it } from 'vitest';
import { writePng } from '../../src/inputs/images/png.ts';
import { type FilesBeside, type Format, readMesh, referencesOf, writeMesh } from '../../src/io/index.ts';
import {
  type AnyJson,
  ascii,
  cubeObj,
  cubePositions,
  cubeQuads,
  gltfBuffer,
  gltfJson,
  packGlb,
  packGltf,
  text,
} from '../fixtures/tiny-files.ts';

/** What a file takes along into another format: texture coordinates, materials, textures, colours, names. */

/** Begins as a PNG does; nobody looks further. */
const png = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 1, 2, 3);
const mtl = [
  ...['# materials', 'newmtl red', 'Kd 1 0 0.5', 'd 0.25', 'map_Kd -s 1 1 1 -clamp on maps\\\\Wood Oak.png'],
  ...['newmtl green', 'Kd 0 1 0', 'Tr 0', ''],
].join('\r\n');

/** A cube: two faces red with a name, two green with another, two red again; one corner of the last has another vt. */
const obj = [
  'mtllib ./my library.mtl',
  ...Array.from({ length: 8 }, (_, v) => `v ${cubePositions.slice(3 * v, 3 * v + 3).join(' ')}`),
  ...['vt 0 0', 'vt 1 0', 'vt 1 0.75', 'vt 0 1', 'vt 0.5 0.5'],
  ...cubeQuads.map((quad, f) => {
    const before = ['o left\nusemtl red', '', 'o right\nusemtl green', '', 'usemtl red', ''][f];
    const corners = quad.map((v, k) => `${v + 1}/${f === 5 && k === 0 ? 5 : k + 1}`);
    return `${before}${before ? '\n' : ''}f ${corners.join(' ')}`;
  }),
  '',
].join('\n');

const beside: FilesBeside = new Map([
  ['my library.mtl', ascii(mtl)],
  ['textures/wood oak.PNG', png],
]);

function become(source: Uint8Array, format: Format, files?: FilesBeside) {
  const { mesh } = readMesh(source, 'a', files);
  const written = writeMesh(source, 'a', format, mesh.positions, files);
  return { ...written, before: mesh, mesh: readMesh(written.bytes, 'b').mesh };
}

function jsonOf(glb: Uint8Array): AnyJson {
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  return JSON.parse(text(glb.subarray(20, 20 + length)));
}

const places = ({ positions, triangles }: { positions: Float64Array; triangles: Uint32Array }) =>
  [...triangles].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);

describe('an OBJ with materials', () => {
  it('refers to them, and they to their textures', () => {
    const bytes = ascii(obj);
    expect(referencesOf(bytes, 'a.obj').map(({ path }) => path)).toEqual([
      'my library.mtl',
      'my',
      'library.mtl',
    ]);
    expect(referencesOf(bytes, 'a.obj', beside)).toEqual([
      { path: 'my library.mtl', isShape: false },
      { path: 'maps/Wood Oak.png', isShape: false },
    ]);
  });

  it.each(['glb', 'gltf'] as const)('becomes %s with all that it has', (format) => {
    const { bytes, warnings, mesh, before } = become(ascii(obj), format, beside);
    expect(warnings).toEqual([]);
    // By material, hence in another order.
    const rows = ({ uvs, ...rest }: typeof mesh) => {
      const at = places(rest);
      return Array.from({ length: uvs!.length / 6 }, (_, t) =>
        [...at.slice(9 * t, 9 * t + 9), ...uvs!.subarray(6 * t, 6 * t + 6)].join(),
      ).sort();
    };
    expect(rows(mesh)).toEqual(rows(before));
    const json = format === 'glb' ? jsonOf(bytes) : JSON.parse(text(bytes));
    const [red, green] = json.materials;
    expect(red).toMatchObject({ name: 'red', alphaMode: 'BLEND' });
    expect(red.pbrMetallicRoughness.baseColorFactor).toEqual([1, 0, expect.closeTo(0.214, 3), 0.25]);
    expect(red.pbrMetallicRoughness.baseColorTexture).toEqual({ index: 0 });
    expect(green).toEqual({
      name: 'green',
      pbrMetallicRoughness: { baseColorFactor: [0, 1, 0, 1], metallicFactor: 0 },
    });
    expect(json.images).toMatchObject([{ name: 'maps/Wood Oak.png', mimeType: 'image/png' }]);
    expect(json.nodes).toEqual([
      { name: 'left', mesh: 0 },
      { name: 'right', mesh: 1 },
    ]);
    expect(json.meshes[1].primitives.map((p: AnyJson) => p.material)).toEqual([1, 0]);
    if (format === 'gltf') return;
    const { byteOffset, byteLength } = json.bufferViews[json.images[0].bufferView];
    const bin = bytes.subarray(28 + new DataView(bytes.buffer).getUint32(12, true));
    expect(bin.slice(byteOffset, byteOffset + byteLength)).toEqual(new Uint8Array(png));
    // And back.
    const back = become(bytes, 'obj');
    expect(rows(back.mesh)).toEqual(rows(before));
    expect(text(back.bytes).match(/^(o|usemtl) .*$/gm)).toEqual([
      'o left',
      'usemtl red',
      'o right',
      'usemtl green',
      'usemtl red',
    ]);
    expect(back.warnings).toEqual([
      'The new OBJ file comes without colours of materials (it keeps their names) and textures.',
    ]);
  });

  it('keeps the order of its positions where each has one pair of texture coordinates', () => {
    const { mesh, before } = become(ascii(cubeObj()), 'glb');
    expect(mesh.positions).toEqual(before.positions);
  });

  it('says which textures it does not take along', () => {
    const without = new Map([['my library.mtl', ascii(mtl)]]);
    expect(become(ascii(obj), 'glb', without).warnings).toEqual([
      '1 texture not found beside the file, so the new one comes without: maps/Wood Oak.png.',
    ]);
    const targa = new Map([...beside, ['textures/wood oak.PNG', ascii('no picture')]]);
    expect(become(ascii(obj), 'glb', targa).warnings).toEqual([
      '1 texture neither PNG nor JPEG, so the new file comes without: maps/Wood Oak.png.',
    ]);
  });

  it.each([
    ['ply-ascii', 'PLY (text) file comes without names of parts, materials and textures.'],
    ['ply-binary', 'PLY file comes without names of parts, materials and textures.'],
  ] as const)('becomes %s with texture coordinates', (format, sentence) => {
    const { mesh, before, warnings } = become(ascii(obj), format, beside);
    expect(warnings).toEqual([`The new ${sentence}`]);
    expect(mesh.uvs).toEqual(before.uvs);
    expect(places(mesh)).toEqual(places(before));
  });

  it.each([
    ['off', 'OFF file comes without texture coordinates, names of parts, materials and textures.'],
    [
      'stl-binary',
      'STL for printing file comes without texture coordinates, names of parts, materials and textures.',
    ],
    [
      'stl-ascii',
      'STL (text) file comes without texture coordinates, names of parts, materials and textures.',
    ],
  ] as const)('says what %s lacks', (format, sentence) => {
    expect(become(ascii(obj), format, beside).warnings).toEqual([`The new ${sentence}`]);
  });

  it('says that its materials are not there, and nothing where nothing is lost', () => {
    expect(become(ascii(obj), 'glb').warnings).toEqual([
      'my library.mtl not found beside the file, so its materials come with their names alone.',
    ]);
    expect(become(ascii('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'), 'stl-binary').warnings).toEqual([]);
    expect(
      become(ascii('v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n'), 'stl-binary').warnings,
    ).toEqual(['The new STL for printing file comes without vertex colours.']);
  });
});

describe('glTF as GLB, and the other way round', () => {
  it('is the same asset', () => {
    const glb = packGlb({ ...gltfJson(), extras: { deep: [1, 2] } });
    const { bytes, mesh, before, warnings } = become(glb, 'gltf');
    expect(warnings).toEqual([]);
    expect(mesh).toEqual(before);
    const json = JSON.parse(text(bytes));
    json.buffers = [{ byteLength: 1032 }];
    json.bufferViews = gltfJson().bufferViews;
    expect(json).toEqual({ ...gltfJson(), extras: { deep: [1, 2] } });
    const back = become(bytes, 'glb');
    expect(back.mesh).toEqual(before);
    expect(back.bytes.slice(-1032)).toEqual(glb.slice(-1032));
  });

  it('takes buffers and images of other files in', () => {
    const json = { ...gltfJson(), images: [{ uri: 'a%20b/Wood.png', name: 'wood' }, { uri: 'gone.png' }] };
    json.buffers = [{ byteLength: 1032, uri: './cube.bin' }];
    const files = new Map([
      ['cube.bin', gltfBuffer()],
      ['a b/Wood.png', png],
    ]);
    const source = ascii(JSON.stringify(json));
    expect(referencesOf(source, 'a.gltf')).toEqual([
      { path: 'cube.bin', isShape: true },
      { path: 'a b/Wood.png', isShape: false },
      { path: 'gone.png', isShape: false },
    ]);
    const { bytes, mesh, before } = become(source, 'glb', files);
    expect(mesh).toEqual(before);
    expect(jsonOf(bytes).images).toEqual([
      { name: 'wood', mimeType: 'image/png', bufferView: 2 },
      { uri: 'gone.png' },
    ]);
  });
});

describe('a glTF with its data beside it', () => {
  const json = gltfJson();
  json.buffers = [{ byteLength: 1032, uri: 'cube.bin' }];
  const source = ascii(JSON.stringify(json));
  const files = new Map([['cube.bin', gltfBuffer()]]);

  it('is read and comes back with its data inside, which is said', () => {
    const { mesh, warnings } = readMesh(source, 'a.gltf', files);
    expect(warnings).toEqual([expect.stringMatching(/data.*beside it \(cube\.bin\).*has it inside/)]);
    expect(mesh).toEqual(readMesh(packGltf(gltfJson()), 'a').mesh);
    // Where nothing moved as well: the result may go where the .bin is not.
    expect(readMesh(writeMesh(source, 'a', 'gltf', mesh.positions, files).bytes, 'b').mesh).toEqual(mesh);
    const moved = mesh.positions.map((value) => value / 2);
    const { bytes } = writeMesh(source, 'a', 'gltf', moved, files);
    expect(readMesh(bytes, 'b').mesh.positions).toEqual(moved);
    expect(files.get('cube.bin')).toEqual(gltfBuffer());
  });

  it('takes in the images that are there and known, and says which stay outside', () => {
    const images = [{ uri: 'wood.png' }, { uri: 'textures/bark.ktx2' }, { uri: 'gone.jpg' }];
    const textured = ascii(JSON.stringify({ ...json, images }));
    const png = writePng({ width: 1, height: 1, data: Uint8Array.of(1, 2, 3, 255) });
    const beside = new Map([...files, ['wood.png', png], ['textures/bark.ktx2', Uint8Array.of(1)]]);
    const { mesh, warnings } = readMesh(textured, 'a.gltf', beside);
    expect(warnings).toEqual([
      expect.stringMatching(/\(cube\.bin, wood\.png\)/),
      expect.stringMatching(/beside it: textures\/bark\.ktx2, gone\.jpg\.$/),
    ]);
    const { bytes } = writeMesh(textured, 'a', 'gltf', mesh.positions, beside);
    const after = JSON.parse(new TextDecoder().decode(bytes)).images;
    expect(Buffer.from(after[0].uri.split(',')[1], 'base64').equals(png)).toBe(true);
    expect(after.slice(1)).toEqual(images.slice(1));
  });

  it('is refused without it', () => {
    expect(() => readMesh(source, 'a.gltf')).toThrow(/"cube\.bin", which is not there; open both together/);
  });
});
