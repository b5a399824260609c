import { beforeAll, describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { dracoCube, meshoptCube } from '../fixtures/compressed.ts';
import { testFiles } from '../fixtures/core.ts';
import { type AnyJson, gltfJson, packGlb, packGltf, text } from '../fixtures/tiny-files.ts';

/** glTF that is compressed: decoded when it is opened, and written without compression. */

const own = readMesh(packGlb(gltfJson()), 'a').mesh;

/** Corners of all triangles, in an order that does not depend on that of the file. */
function triangles({ positions, triangles: corners }: typeof own): string[] {
  const rounded = (v: number) =>
    [...positions.subarray(3 * v, 3 * v + 3)].map((x) => Math.round(1000 * x) / 1000 + 0);
  const rows: string[] = [];
  for (let c = 0; c < corners.length; c += 3) {
    const triangle = [0, 1, 2].map((k) => rounded(corners[c + k]!).join(' '));
    const least = triangle.indexOf([...triangle].sort()[0]!);
    rows.push([...triangle.slice(least), ...triangle.slice(0, least)].join(', '));
  }
  return rows.sort();
}

const jsonOf = (glb: Uint8Array): AnyJson =>
  JSON.parse(text(glb.subarray(20, 20 + new DataView(glb.buffer, glb.byteOffset).getUint32(12, true))));

describe.each([
  ['meshopt', () => meshoptCube(packGlb)],
  ['Draco', dracoCube],
] as const)('%s', (what, make) => {
  let file: Uint8Array<ArrayBuffer>;
  beforeAll(async () => {
    file = await make();
  });

  it('is decoded when the file is opened, which is said', async () => {
    const { mesh, format, warnings } = await testFiles.readMesh(file, 'a.glb');
    expect(format).toBe('glb');
    expect(warnings).toEqual([`It is compressed with ${what}; the result is not, and hence larger.`]);
    expect(triangles(mesh)).toEqual(triangles(own));
  });

  it('is gone from what is written, and all else is there', async () => {
    const { mesh } = await testFiles.readMesh(file, 'a.glb');
    const moved = mesh.positions.map((value) => value / 2);
    const { bytes } = await testFiles.writeMesh(file, 'a.glb', 'glb', moved);
    const again = readMesh(bytes, 'b.glb');
    expect(again.warnings).toEqual([]);
    expect(again.mesh.positions).toEqual(moved);
    expect(again.mesh.triangles).toEqual(mesh.triangles);
    const json = jsonOf(bytes);
    expect(text(bytes)).not.toMatch(/_compression/);
    expect(json.materials).toEqual(gltfJson().materials);
    expect(json.extensionsRequired).toBeUndefined();
    if (what === 'Draco')
      expect(json.meshes[0].primitives[0].extensions).toEqual({ EXT_other: { keep: true } });
    else {
      expect(json.extensionsUsed).toEqual(['EXT_unknown']);
      const { byteOffset, byteLength } = json.bufferViews[json.images[0].bufferView];
      const begin = 28 + new DataView(bytes.buffer).getUint32(12, true) + byteOffset;
      expect([...bytes.subarray(begin, begin + byteLength)]).toEqual([1, 2, 3]);
    }
  });

  it('is refused in a sentence where it is broken, and where nobody decodes it', async () => {
    const broken = file.slice();
    broken.fill(77, 28 + new DataView(file.buffer).getUint32(12, true));
    await expect(testFiles.readMesh(broken, 'a.glb')).rejects.toMatchObject({
      code: 'malformed-file',
      message: expect.stringMatching(new RegExp(`^a\\.glb, buffer view \\d: its ${what} data is broken`)),
    });
    expect(() => readMesh(file, 'a.glb')).toThrow(/open it with an engine/);
  });
});

it('meshopt in a text file is decoded too', async () => {
  const { mesh, format } = await testFiles.readMesh(await meshoptCube(packGltf), 'a.gltf');
  expect(format).toBe('gltf');
  expect(mesh).toEqual(own);
});

it('a file that is not compressed is passed on as it is', async () => {
  const never = () => {
    throw new Error('no decoder is needed');
  };
  const { uncompressed } = await import('../../src/io/index.ts');
  for (const file of [packGlb(gltfJson()), packGltf(gltfJson()), new Uint8Array([123]), new Uint8Array()])
    expect((await uncompressed(file, 'a', never)).bytes).toBe(file);
});
