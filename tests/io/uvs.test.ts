import { describe, expect, test } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { bakedGlb, plate } from '../fixtures/textured.ts';
import { type AnyJson, ascii, gltfBuffer, gltfJson, packGlb, text } from '../fixtures/tiny-files.ts';

const uvsOf = (text: string, name: string): number[] | undefined => {
  const { uvs } = readMesh(ascii(text), name).mesh;
  return uvs && [...uvs];
};
/** Texture coordinates by position, so that it shows whether corners followed their polygon. */
function uvByCorner(bytes: Uint8Array): [position: number, u: number, v: number][] {
  const { triangles, uvs } = readMesh(bytes, 'mesh').mesh;
  return [...triangles].map((position, corner) => [position, uvs![2 * corner]!, uvs![2 * corner + 1]!]);
}

describe('OBJ', () => {
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

  test('a corner keeps its own coordinates, also across a seam, with any kind of reference', () => {
    const text = `${square}vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.25\nf 1/1 2/2 3/3\nf 1/4/1 3/-2/1 4/-1\nvn 0 0 1\n`;
    expect(uvsOf(text, 'a.obj')).toEqual([0, 0, 1, 0, 1, 1, 0.5, 0.25, 1, 1, 0.5, 0.25]);
  });

  test('they follow when a polygon is split, a concave one too', () => {
    const dart = 'v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv 9 9 9\n';
    const uvs = 'vt 0 0\nvt 4 0\nvt 1 1\nvt 0 4\n';
    const corners = uvByCorner(ascii(`${dart}${uvs}f 1/1 2/2 3/3 4/4\n`));
    expect(corners).toHaveLength(6);
    const place = [
      [0, 0],
      [4, 0],
      [1, 1],
      [0, 4],
    ];
    for (const [position, u, v] of corners) expect([u, v]).toEqual(place[position]);
  });

  test('corners without any, and references to none, are NaN; a file whose faces use none has none', () => {
    const [a, , , b] = [`${square}vt 0.5 0.5\nf 1/1 2/9 3\n`, '', '', `${square}vt 0 0\nf 1 2 3\n`];
    expect(uvsOf(a, 'a.obj')).toEqual([0.5, 0.5, NaN, NaN, NaN, NaN]);
    expect(uvsOf(b, 'b.obj')).toBeUndefined();
    expect(uvsOf(`${square}vt 0 0\nf 1//1 2//1 3//1\n`, 'c.obj')).toBeUndefined();
  });
});

describe('PLY', () => {
  const head = (vertex: string, face: string) =>
    `ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n${vertex}` +
    `element face 1\nproperty list uchar int vertex_indices\n${face}end_header\n`;

  test.each([
    ['s', 't'],
    ['u', 'v'],
    ['texture_u', 'texture_v'],
  ])('of vertices, as %s and %s', (u, v) => {
    const text = `${head(`property float ${u}\nproperty float ${v}\n`, '')}0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 0.5\n0 1 0 0 0.5\n4 0 1 2 3\n`;
    expect(uvsOf(text, 'a.ply')).toEqual([0, 0, 1, 0, 1, 0.5, 0, 0, 1, 0.5, 0, 0.5]);
  });

  test('of corners, as a list of each face, before or behind its vertices', () => {
    const rows = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n';
    const list = 'property list uchar float texcoord\n';
    const behind = `${head('', list)}${rows}4 0 1 2 3 8 0 0 1 0 1 0.5 0 0.5\n`;
    expect(uvsOf(behind, 'a.ply')).toEqual([0, 0, 1, 0, 1, 0.5, 0, 0, 1, 0.5, 0, 0.5]);
    const before = behind
      .replace(
        `property list uchar int vertex_indices\n${list}`,
        `${list}property list uchar int vertex_indices\n`,
      )
      .replace('4 0 1 2 3 8 0 0 1 0 1 0.5 0 0.5', '8 0 0 1 0 1 0.5 0 0.5 4 0 1 2 3');
    expect(uvsOf(before, 'b.ply')).toEqual(uvsOf(behind, 'a.ply'));
    expect(uvsOf(`${head('', list)}${rows}4 0 1 2 3 2 0 0\n`, 'c.ply')).toBeUndefined();
  });
});

describe('OFF', () => {
  test('ST: the last two numbers of a vertex, behind its colour', () => {
    const text = 'STCOFF\n3 1 0\n0 0 0 1 0 0 1 0.25 0.5\n1 0 0 1 0 0 1 1 0\n0 1 0 1 0 0 1 0 1\n3 0 1 2\n';
    expect(uvsOf(text, 'a.off')).toEqual([0.25, 0.5, 1, 0, 0, 1]);
    expect(uvsOf('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n', 'b.off')).toBeUndefined();
  });
});

describe('glTF', () => {
  /** The flat-shaded cube with 16-bit coordinates in a buffer view of their own: its corners' numbers in thirds. */
  function withUvs(count = 24): Uint8Array {
    const json = gltfJson();
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = 4;
    json.accessors.push({ bufferView: 2, componentType: 5123, normalized: true, count, type: 'VEC2' });
    json.bufferViews.push({ buffer: 0, byteOffset: 1032, byteLength: 96 });
    json.buffers[0].byteLength = 1128;
    const bytes = new Uint8Array(1128);
    bytes.set(gltfBuffer());
    const view = new DataView(bytes.buffer);
    for (let v = 0; v < 24; v++) view.setUint16(1032 + 4 * v, (v % 4) * 21845, true);
    return packGlb(json, bytes);
  }

  test('v is turned upward: the top row of the picture is at 1', () => {
    for (const [position, u, v] of uvByCorner(withUvs())) {
      expect(u).toBeCloseTo((position % 4) / 3, 6);
      expect(v).toBe(1);
    }
  });

  test('too few of them are left out, and it says so; a primitive without has NaN', () => {
    const { mesh, warnings } = readMesh(withUvs(20), 'a.glb');
    expect(mesh.uvs).toBeUndefined();
    expect(warnings).toEqual([expect.stringContaining('texture coordinates of mesh 0, primitive 0')]);
    expect(readMesh(packGlb(gltfJson()), 'b.glb').mesh.uvs).toBeUndefined();
  });
});

test('STL has none', () => {
  const facet =
    'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';
  expect(uvsOf(`solid a\n${facet}endsolid a\n`, 'a.stl')).toBeUndefined();
});

describe('a normal map inside a glTF', () => {
  const png = Uint8Array.of(137, 80, 78, 71, 1, 2, 3);
  const read = (change: (json: AnyJson) => void) => {
    const glb = bakedGlb(plate(2), png);
    const length = new DataView(glb.buffer).getUint32(12, true);
    const json = JSON.parse(text(glb.subarray(20, 20 + length)));
    change(json);
    return readMesh(packGlb(json, glb.slice(28 + length)), 'a.glb');
  };

  test('is handed on with its name', () => {
    expect(read(() => {}).normalMap).toEqual({ name: 'baked', bytes: png });
    const inline = read((json) => {
      json.images[0] = { uri: 'data:image/png;base64,iVBORw==' };
    });
    expect(inline.normalMap).toEqual({ name: 'normal map', bytes: png.slice(0, 4) });
  });

  test.each<[string, (json: AnyJson) => void]>([
    ['other coordinates', (json) => Object.assign(json.materials[0].normalTexture, { texCoord: 1 })],
    ['no texture', (json) => Object.assign(json.materials[0].normalTexture, { index: 7 })],
    ['another file', (json) => Object.assign(json, { images: [{ uri: 'map.png' }] })],
    ['no place', (json) => Object.assign(json.images[0], { bufferView: 9 })],
    ['no buffer', (json) => Object.assign(json.bufferViews[2], { buffer: 5 })],
    ['no material', (json) => Object.assign(json, { materials: 3 })],
    [
      'not all parts',
      (json) => json.meshes[0].primitives.push({ ...json.meshes[0].primitives[0], material: undefined }),
    ],
  ])('%s: there is none, and the mesh is read all the same', (_, change) => {
    const { normalMap, mesh } = read(change);
    expect(normalMap).toBeUndefined();
    expect(mesh.uvs).toBeDefined();
  });
});
