import type { DracoArray, DracoDecoder, DracoGeometry, DracoModule } from 'draco3d/draco_decoder_nodejs.js';
import type { Compression, Decoders, DracoAttributes, DracoMesh } from '../io/index.ts';

/** What holds numbers of glTF's kinds of component. */
const arrays = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;

/** Loads what undoes a compression. @param readWasm the bytes of Draco's decoder */
export async function loadDecoder(
  compression: Compression,
  readWasm: () => Promise<Uint8Array>,
): Promise<Decoders> {
  if (compression === 'meshopt') {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder');
    await MeshoptDecoder.ready;
    return { meshopt: MeshoptDecoder.decodeGltfBuffer };
  }
  const { default: createDecoder } = await import('draco3d/draco_decoder_nodejs.js');
  const module = await createDecoder({ wasmBinary: await readWasm() });
  return { draco: (bytes, attributes) => decode(module, bytes, attributes) };
}

function decode(module: DracoModule, bytes: Uint8Array, attributes: DracoAttributes): DracoMesh {
  const decoder = new module.Decoder();
  const mesh = new module.Mesh();
  const integers = new module.DracoInt32Array();
  const floats = new module.DracoFloat32Array();
  try {
    const source = new Int8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (!decoder.DecodeArrayToMesh(source, bytes.length, mesh).ok()) throw new Error('It is no Draco mesh.');
    return {
      vertices: mesh.num_points(),
      indices: facesOf(decoder, mesh, integers),
      attributes: attributes.map((wish) => attributeOf(decoder, mesh, wish, integers, floats)),
    };
  } finally {
    for (const object of [floats, integers, mesh, decoder]) module.destroy(object);
  }
}

function facesOf(decoder: DracoDecoder, mesh: DracoGeometry, face: DracoArray): Uint32Array {
  const indices = new Uint32Array(3 * mesh.num_faces());
  for (let f = 0; 3 * f < indices.length; f++) {
    decoder.GetFaceFromMesh(mesh, f, face);
    for (let k = 0; k < 3; k++) indices[3 * f + k] = face.GetValue(k);
  }
  return indices;
}

function attributeOf(
  decoder: DracoDecoder,
  mesh: DracoGeometry,
  { id, componentType }: DracoAttributes[number],
  integers: DracoArray,
  floats: DracoArray,
): Uint8Array {
  const attribute = decoder.GetAttributeByUniqueId(mesh, id);
  const Numbers = arrays[componentType as keyof typeof arrays];
  if (!Numbers || attribute.ptr === 0) throw new Error(`There is no attribute ${id}.`);
  const isFloat = Numbers === Float32Array;
  const from = isFloat ? floats : integers;
  const isThere = isFloat
    ? decoder.GetAttributeFloatForAllPoints(mesh, attribute, from)
    : decoder.GetAttributeInt32ForAllPoints(mesh, attribute, from);
  if (!isThere) throw new Error(`Attribute ${id} cannot be decoded.`);
  const values = new Numbers(from.size());
  for (let i = 0; i < values.length; i++) values[i] = from.GetValue(i);
  return new Uint8Array(values.buffer);
}
