import { describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { type AnyJson, gltfBuffer, gltfJson, packGlb, packGltf, text } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

const read = (json: AnyJson, bin = gltfBuffer()) => readMesh(packGlb(json, bin), 'a.glb');

/** Reads the JSON and the binary chunk of a GLB back. */
function unpack(glb: Uint8Array): { json: AnyJson; source: string; bin: DataView } {
  const view = new DataView(glb.buffer, glb.byteOffset);
  const jsonLength = view.getUint32(12, true);
  expect(jsonLength % 4).toBe(0);
  expect(view.getUint32(8, true)).toBe(glb.length);
  const source = text(glb.subarray(20, 20 + jsonLength));
  const binLength = view.getUint32(20 + jsonLength, true);
  const bin = new DataView(glb.buffer, glb.byteOffset + 28 + jsonLength, binLength);
  return { json: JSON.parse(source), source, bin };
}

describe('transforms', () => {
  it('are applied when reading and undone when writing', () => {
    const glb = packGlb(gltfJson());
    const { positions } = readMesh(glb, 'a.glb').mesh;
    expect([Math.min(...positions), Math.max(...positions)]).toEqual([0, 12]);
    const up = positions.map((value, i) => (i % 3 === 1 ? value * 3 : value));
    const { json, bin } = unpack(writtenBytes(glb, 'a.glb', 'glb', up));
    expect(json.accessors[0]).toMatchObject({ min: [0, 0, 0], max: [1, 3, 1] });
    for (let v = 0; v < 24; v++)
      expect(bin.getFloat32(40 * v + 4, true)).toBe(3 * gltfView.getFloat32(40 * v + 4, true));
  });

  it('take matrices, rotations and mirrors, and normals follow into the local frame', () => {
    const json = gltfJson();
    json.nodes[0] = { mesh: 0, rotation: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], scale: [1, 1, -4] };
    json.nodes[1].matrix = [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
    delete json.nodes[1].translation;
    const glb = packGlb(json);
    const { positions } = readMesh(glb, 'a.glb').mesh;
    const { bin } = unpack(
      writtenBytes(
        glb,
        'a.glb',
        'glb',
        positions.map((value) => value * 2),
      ),
    );
    // A uniform scale about the scene's origin keeps every normal, whatever the nodes do.
    for (let v = 0; v < 24; v++) {
      for (let i = 3; i < 9; i++) {
        expect(bin.getFloat32(40 * v + 4 * i, true)).toBeCloseTo(
          gltfView.getFloat32(40 * v + 4 * i, true),
          6,
        );
      }
    }
    expect(bin.getFloat32(0, true)).not.toBe(0);
  });

  const gltfView = new DataView(gltfBuffer().buffer);
});

describe('writing', () => {
  it('changes nothing but positions, normals, tangents, and their bounds', () => {
    const glb = packGlb(gltfJson());
    const { positions } = readMesh(glb, 'a.glb').mesh;
    const changed = positions.slice();
    for (let i = 0; i < positions.length; i += 3) if (positions[i + 2] === 2) changed[i] += positions[i + 1];
    const before = unpack(glb);
    const after = unpack(writtenBytes(glb, 'a.glb', 'glb', changed));
    expect(after.source.trimEnd()).toBe(before.source.trimEnd().replace('"max":[1,1,1]', '"max":[2,1,1]'));
    for (let at = 960; at < 1032; at++) expect(after.bin.getUint8(at)).toBe(before.bin.getUint8(at));
    for (let v = 0; v < 24; v++) {
      const vector = (first: number, n: number) =>
        Array.from({ length: n }, (_, i) => after.bin.getFloat32(40 * v + 4 * (first + i), true));
      const normal = vector(3, 3);
      const tangent = vector(6, 4);
      expect(Math.hypot(...normal)).toBeCloseTo(1, 6);
      expect(Math.hypot(...tangent.slice(0, 3))).toBeCloseTo(1, 6);
      expect(normal[0] * tangent[0] + normal[1] * tangent[1] + normal[2] * tangent[2]).toBeCloseTo(0, 6);
      expect(tangent[3]).toBe(1);
    }
  });

  it('touches only the base64 of a data URI', () => {
    const gltf = packGltf(gltfJson());
    const positions = readMesh(gltf, 'a.gltf').mesh.positions.map((value) => value * 2);
    const strip = (source: string) =>
      source.replace(/base64,[^"]*/, '').replace(/"(min|max)": ?\[[^\]]*\]/g, '"$1"');
    expect(strip(text(writtenBytes(gltf, 'a.gltf', 'gltf', positions)))).toBe(strip(text(gltf)));
  });

  it('gives bounds that hold the stored numbers exactly', () => {
    const glb = packGlb(gltfJson());
    const positions = readMesh(glb, 'a.glb').mesh.positions.map((value) => value * 0.1);
    const written = writtenBytes(glb, 'a.glb', 'glb', positions);
    const { json, bin } = unpack(written);
    const stored = Array.from({ length: 24 }, (_, v) => bin.getFloat32(40 * v, true));
    expect(json.accessors[0].max[0]).toBe(Math.max(...stored));
    expect(json.accessors[0].min[0]).toBe(Math.min(...stored));
  });
});

describe('kinds of data', () => {
  it('reads strips, fans and plain lists of vertices with one winding', () => {
    const bin = new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0).buffer);
    const json = simple();
    expect(Array.from(read({ ...json, ...mode(json, 5) }, bin).mesh.triangles)).toEqual([0, 1, 2, 2, 1, 3]);
    expect(Array.from(read({ ...json, ...mode(json, 6) }, bin).mesh.triangles)).toEqual([0, 1, 2, 0, 2, 3]);
    json.accessors[0].count = 3;
    expect(Array.from(read(json, bin).mesh.triangles)).toEqual([0, 1, 2]);
  });

  const simple = (): AnyJson => ({
    asset: { version: '2.0' },
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' }],
    bufferViews: [{ buffer: 0, byteLength: 48 }],
    buffers: [{ byteLength: 48 }],
  });
  const mode = (json: AnyJson, value: number) => ({
    meshes: [{ primitives: [{ ...json.meshes[0].primitives[0], mode: value }] }],
  });

  /** A triangle of bytes, as quantized files have them. */
  const quantized = (): [AnyJson, Uint8Array<ArrayBuffer>] => {
    const bin = new Uint8Array(16);
    bin.set([0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0]);
    const json = simple();
    Object.assign(json.accessors[0], { componentType: 5121, normalized: true, count: 3, name: 'kept' });
    json.bufferViews[0] = { buffer: 0, byteLength: 12, byteStride: 4 };
    json.buffers[0].byteLength = 12;
    json.extensionsUsed = ['KHR_mesh_quantization'];
    json.nodes = [{ mesh: 0, scale: [4, 4, 4], translation: [1, 0, 0] }];
    return [json, bin];
  };

  it.each([packGlb, packGltf])('gives whole numbers a buffer view of decimal ones: %o', (pack) => {
    const [json, bin] = quantized();
    const file = pack(json, bin);
    const { mesh, format, warnings } = readMesh(file, 'q');
    expect(warnings).toEqual([expect.stringMatching(/whole numbers; in the result they are decimal ones/)]);
    expect(Array.from(mesh.positions)).toEqual([1, 0, 0, 5, 0, 0, 1, 4, 0]);
    expect(writtenBytes(file, 'q', format, mesh.positions)).toEqual(file);
    const half = mesh.positions.map((value) => value / 2);
    const written = writtenBytes(file, 'q', format, half);
    const again = readMesh(written, 'q');
    expect(again.warnings).toEqual([]);
    expect(again.mesh.positions).toEqual(half);
    expect(writtenBytes(written, 'q', format, half)).toEqual(written);
    if (pack !== packGlb) return;
    const after = unpack(written);
    const accessor = { componentType: 5126, count: 3, type: 'VEC3', name: 'kept', bufferView: 1 };
    expect(after.json).toEqual({
      ...json,
      accessors: [{ ...accessor, min: [-0.125, 0, 0], max: [0.375, 0.5, 0] }],
      bufferViews: [json.bufferViews[0], { buffer: 0, byteOffset: 16, byteLength: 36, target: 34962 }],
      buffers: [{ byteLength: 52 }],
    });
    // What follows the chunk stays where it is.
    const extra = new Uint8Array([4, 0, 0, 0, 88, 89, 90, 0, 1, 2, 3, 4]);
    const longer = writtenBytes(packGlb(json, bin, extra), 'q', 'glb', half);
    expect(longer.subarray(-12)).toEqual(extra);
    expect(readMesh(longer, 'q').mesh.positions).toEqual(half);
  });

  it('gives positions that are zero because nothing is stored a place, if there is one', () => {
    const [json, bin] = quantized();
    json.accessors.push({ componentType: 5126, count: 3, type: 'VEC3' });
    json.meshes[0].primitives.push({ attributes: { POSITION: 1 } });
    const { positions } = readMesh(packGlb(json, bin), 'q').mesh;
    const moved = positions.map((_, i) => i);
    expect(readMesh(writtenBytes(packGlb(json, bin), 'q', 'glb', moved), 'q').mesh.positions).toEqual(moved);
    const bare = { ...simple(), accessors: [json.accessors[1]], bufferViews: [], buffers: [] };
    expect(() => writtenBytes(packGlb(bare, bin), 'q', 'glb', moved.slice(0, 9))).toThrow(
      /not stored at all/,
    );
  });

  it('reads sparse positions and writes each where it is stored', () => {
    const bin = new Uint8Array(64);
    const view = new DataView(bin.buffer);
    [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((value, i) => {
      view.setFloat32(4 * i, value, true);
    });
    view.setUint8(36, 2);
    [0, 0, 9].forEach((value, i) => {
      view.setFloat32(40 + 4 * i, value, true);
    });
    const json = simple();
    json.accessors[0] = {
      ...json.accessors[0],
      count: 3,
      sparse: { count: 1, indices: { bufferView: 1, componentType: 5121 }, values: { bufferView: 2 } },
    };
    json.bufferViews = [
      { buffer: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 1 },
      { buffer: 0, byteOffset: 40, byteLength: 12 },
    ];
    json.buffers[0].byteLength = 52;
    const glb = packGlb(json, bin);
    const { positions } = readMesh(glb, 's.glb').mesh;
    expect(Array.from(positions)).toEqual([0, 0, 0, 1, 0, 0, 0, 0, 9]);
    const { bin: after } = unpack(
      writtenBytes(glb, 's.glb', 'glb', Float64Array.of(0, 0, 0, 2, 0, 0, 0, 0, 8)),
    );
    expect([12, 24, 28, 48].map((at) => after.getFloat32(at, true))).toEqual([2, 0, 1, 8]);
  });

  it('takes a mesh that stands twice once, and says so', () => {
    const json = gltfJson();
    json.nodes.push({ mesh: 0, translation: [100, 0, 0] });
    json.scenes[0].nodes.push(2);
    const { mesh, warnings } = read(json);
    expect(mesh.positions).toHaveLength(72);
    expect(Math.max(...mesh.positions)).toBe(12);
    expect(warnings.join()).toContain('1 copy');
  });

  it('shares positions between primitives', () => {
    const json = gltfJson();
    json.meshes[0].primitives.push({ attributes: { POSITION: 0, NORMAL: 1 }, indices: 3 });
    const { mesh } = read(json);
    expect([mesh.positions.length, mesh.triangles.length]).toEqual([72, 72]);
  });

  it('says what it leaves out', () => {
    const json = gltfJson();
    json.meshes[0].primitives[0].targets = [{ POSITION: 0 }];
    json.meshes[0].primitives.push({ attributes: { POSITION: 0 }, mode: 1 });
    json.nodes[0].skin = 0;
    const { warnings } = read(json);
    expect(warnings.join(' ')).toMatch(/skeleton.*morph.*1 part made of points or lines/);
  });

  it('reads colours as they are, in linear light', () => {
    const bin = new Uint8Array(64);
    new DataView(bin.buffer).setFloat32(12, 1, true);
    new DataView(bin.buffer).setFloat32(28, 1, true);
    bin.set([255, 51, 0, 255], 36);
    const json = simple();
    json.accessors[0].count = 3;
    json.accessors.push({
      bufferView: 0,
      byteOffset: 36,
      componentType: 5121,
      normalized: true,
      count: 3,
      type: 'VEC4',
    });
    json.meshes[0].primitives[0].attributes.COLOR_0 = 1;
    const colors = read(json, bin).mesh.colors!;
    expect(Array.from(colors.subarray(0, 3))).toEqual([1, Math.fround(0.2), 0]);
  });

  it('has the same cube in text and binary', () => {
    expect(readMesh(packGltf(gltfJson()), 'a').mesh).toEqual(read(gltfJson()).mesh);
  });
});
