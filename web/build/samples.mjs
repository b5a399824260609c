// Makes public/samples: two CC0 meshes out of a dev dependency, decoded from Draco to plain glTF, and three of our own.
// Run by Vite before it serves or builds, or by hand: node web/build/samples.mjs [--force]
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { normalsOf, subdivide } from './loop-subdivision.mjs';
import { openVase, pebbleKnot, roundJar } from './own-shapes.mjs';

const folder = join(dirname(fileURLToPath(import.meta.url)), '../../public/samples');
const version = '4';

const borrowed = [
  { from: 'bunny', file: 'rabbit.glb', finer: true },
  { from: 'suzi', file: 'suzanne.glb', finer: false },
];

const attribution = `# Sample meshes

| file | made by | licence |
|---|---|---|
| rabbit.glb | pmndrs assets (npm @pmndrs/assets, models/bunny.glb), decoded from Draco, subdivided once | CC0 1.0 |
| suzanne.glb | pmndrs assets (npm @pmndrs/assets, models/suzi.glb), decoded from Draco | CC0 1.0 |
| vase.obj, knot.ply, jar.glb | Whittle's own generators (web/build/own-shapes.mjs) | CC0 1.0 |
`;

/** Writes the samples unless they are there in this version. */
export async function makeSamples({ force = false } = {}) {
  const stamp = join(folder, '.version');
  if (!force && existsSync(stamp) && readFileSync(stamp, 'utf8') === version) return;
  mkdirSync(folder, { recursive: true });
  for (const { from, file, finer } of borrowed) keep(file, await decodedGlb(from, finer));
  keep('vase.obj', openVase());
  keep('knot.ply', pebbleKnot());
  const jar = roundJar();
  keep('jar.glb', plainGlb('jar', { ...jar, normals: normalsOf(jar) }));
  keep('ATTRIBUTION.md', attribution);
  keep('.version', version);
}

/** In one move, so that nobody who reads meanwhile gets half a file. */
function keep(file, data) {
  const unfinished = join(folder, `.${file}.${process.pid}`);
  writeFileSync(unfinished, data);
  renameSync(unfinished, join(folder, file));
}

async function decodedGlb(name, finer) {
  const { default: dataUri } = await import(`@pmndrs/assets/models/${name}.glb.js`);
  const { json, binary } = splitGlb(Buffer.from(dataUri.slice(dataUri.indexOf(',') + 1), 'base64'));
  const [primitive] = json.meshes[0].primitives;
  const packed = primitive.extensions.KHR_draco_mesh_compression;
  const view = json.bufferViews[packed.bufferView];
  const bytes = binary.subarray(view.byteOffset ?? 0, (view.byteOffset ?? 0) + view.byteLength);
  const mesh = await decodeDraco(bytes, packed.attributes);
  if (!finer) return plainGlb(name, mesh);
  const fine = subdivide(mesh);
  return plainGlb(name, { ...fine, normals: normalsOf(fine) });
}

function splitGlb(glb) {
  const jsonLength = glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, 20 + jsonLength));
  const start = 20 + jsonLength;
  return { json, binary: glb.subarray(start + 8, start + 8 + glb.readUInt32LE(start)) };
}

/** Positions, normals and indices of a Draco triangle mesh. */
async function decodeDraco(bytes, attributes) {
  const { default: draco3d } = await import('draco3d');
  const draco = await draco3d.createDecoderModule({});
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  const status = decoder.DecodeArrayToMesh(new Int8Array(bytes), bytes.length, mesh);
  if (!status.ok()) throw new Error(`Draco: ${status.error_msg()}`);
  const floats = (id) => {
    const values = new draco.DracoFloat32Array();
    decoder.GetAttributeFloatForAllPoints(mesh, decoder.GetAttributeByUniqueId(mesh, id), values);
    const copy = Float32Array.from({ length: values.size() }, (_, i) => values.GetValue(i));
    draco.destroy(values);
    return copy;
  };
  const face = new draco.DracoInt32Array();
  const indices = new Uint32Array(3 * mesh.num_faces());
  for (let f = 0; f < mesh.num_faces(); f++) {
    decoder.GetFaceFromMesh(mesh, f, face);
    for (let c = 0; c < 3; c++) indices[3 * f + c] = face.GetValue(c);
  }
  return { positions: floats(attributes.POSITION), normals: floats(attributes.NORMAL), indices };
}

/** A glTF binary with one mesh and nothing compressed. Texture coordinates (v upward) only where there are any. */
function plainGlb(name, { positions, normals, indices, uvs }) {
  const downward = uvs?.map((value, i) => (i % 2 === 0 ? value : 1 - value));
  const parts = [positions, normals, indices, ...(downward ? [downward] : [])];
  const lengths = parts.map((part) => part.byteLength);
  const box = (pick) =>
    [0, 1, 2].map((axis) =>
      positions.reduce((best, x, i) => (i % 3 === axis ? pick(best, x) : best), pick()),
    );
  const json = {
    asset: { version: '2.0', generator: 'whittle samples' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [
      {
        name,
        primitives: [
          {
            attributes: { POSITION: 0, NORMAL: 1, ...(uvs ? { TEXCOORD_0: 3 } : {}) },
            indices: 2,
            material: 0,
          },
        ],
      },
    ],
    materials: [{ name: 'clay', pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.7 } }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: positions.length / 3,
        type: 'VEC3',
        min: box(Math.min),
        max: box(Math.max),
      },
      { bufferView: 1, componentType: 5126, count: normals.length / 3, type: 'VEC3' },
      { bufferView: 2, componentType: 5125, count: indices.length, type: 'SCALAR' },
      ...(uvs ? [{ bufferView: 3, componentType: 5126, count: uvs.length / 2, type: 'VEC2' }] : []),
    ],
    bufferViews: lengths.map((byteLength, i) => ({
      buffer: 0,
      byteOffset: lengths.slice(0, i).reduce((a, b) => a + b, 0),
      byteLength,
      target: i === 2 ? 34963 : 34962,
    })),
    buffers: [{ byteLength: lengths.reduce((a, b) => a + b, 0) }],
  };
  const binary = Buffer.concat(
    parts.map((part) => Buffer.from(part.buffer, part.byteOffset, part.byteLength)),
  );
  return glbOf(Buffer.from(JSON.stringify(json)), binary);
}

function glbOf(json, binary) {
  const padded = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, ' ')]);
  const header = Buffer.alloc(20);
  header.write('glTF', 0);
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(28 + padded.length + binary.length, 8);
  header.writeUInt32LE(padded.length, 12);
  header.write('JSON', 16);
  const chunk = Buffer.alloc(8);
  chunk.writeUInt32LE(binary.length, 0);
  chunk.write('BIN\0', 4);
  return Buffer.concat([header, padded, chunk, binary]);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  await makeSamples({ force: process.argv.includes('--force') });
