import { concatenate } from '../bytes.ts';
import { refusal } from '../refuse.ts';
import type { GltfDocument, Json } from './document.ts';
import { type GltfPieces, paddedPieces } from './pack.ts';

/** How data of a glTF may be compressed. */
export type Compression = 'Draco' | 'meshopt';

/** Decodes a buffer view that is compressed with meshopt. @throws Error where it is broken */
export type DecodeMeshopt = (
  target: Uint8Array,
  count: number,
  stride: number,
  source: Uint8Array,
  mode: string,
  filter: string | undefined,
) => void;

/** Which attributes of a Draco mesh are wanted: by their ids there, and as which kind of component. */
export type DracoAttributes = readonly { readonly id: number; readonly componentType: number }[];

/** A primitive that was compressed with Draco. */
export interface DracoMesh {
  readonly vertices: number;
  /** #F×3 */
  readonly indices: Uint32Array;
  /** The bytes of each attribute, in the order in which they were asked for. */
  readonly attributes: readonly Uint8Array[];
}

/** Decodes a primitive. @throws Error where it is broken */
export type DecodeDraco = (bytes: Uint8Array, attributes: DracoAttributes) => DracoMesh;

/** What can undo compression; each is there only where it was asked for. */
export interface Decoders {
  readonly meshopt?: DecodeMeshopt;
  readonly draco?: DecodeDraco;
}

const draco = 'KHR_draco_mesh_compression';
const meshopt = /^(EXT|KHR)_meshopt_compression$/;

/** How a file is compressed, if it is. */
export function compressionsOf(document: GltfDocument): Compression[] {
  const { root } = document;
  const isDraco = primitivesOf(document).some(
    ({ extensions }) => isRecord(extensions) && draco in extensions,
  );
  const isMeshopt = document.list(root, 'bufferViews').some((view) => meshoptOf(view as Json) !== undefined);
  return [...(isDraco ? (['Draco'] as const) : []), ...(isMeshopt ? (['meshopt'] as const) : [])];
}

/**
 * Writes an asset again without compression, in one buffer: buffer views and primitives decoded, and all else as it was.
 *
 * @throws unsupported-file, truncated-file, malformed-file
 */
export function expandGltf(document: GltfDocument, decoders: Decoders): GltfPieces {
  return new Expansion(document, decoders).run();
}

class Expansion {
  readonly #document: GltfDocument;
  readonly #decoders: Decoders;
  readonly #pieces: Uint8Array[] = [];
  readonly #views: Json[] = [];
  #length = 0;

  constructor(document: GltfDocument, decoders: Decoders) {
    this.#document = document;
    this.#decoders = decoders;
  }

  run(): GltfPieces {
    const root = structuredClone(this.#document.root) as Record<string, unknown>;
    const ofDraco = this.#viewsOfDraco();
    this.#document.list(root, 'bufferViews').forEach((view, i) => {
      this.#view(this.#document.record(view, `buffer view ${i}`), i, ofDraco.has(i));
    });
    for (const primitive of primitivesIn(root)) this.#primitive(primitive, root);
    const json = { ...root, bufferViews: this.#views, buffers: [{ byteLength: this.#length }] };
    for (const key of ['extensionsUsed', 'extensionsRequired']) {
      const list = root[key];
      if (!Array.isArray(list)) continue;
      const rest = list.filter((name) => name !== draco && !meshopt.test(String(name)));
      Object.assign(json, { [key]: rest.length > 0 ? rest : undefined });
    }
    return { json, bin: concatenate(paddedPieces(this.#pieces)) };
  }

  /** Buffer views that nothing needs once the primitives in them are decoded. */
  #viewsOfDraco(): Set<unknown> {
    return new Set(primitivesOf(this.#document).map(({ extensions }) => dracoOf(extensions)?.bufferView));
  }

  #view(view: Json, index: number, isOfDraco: boolean): void {
    const compressed = meshoptOf(view);
    const { extensions, ...rest } = view;
    // Its place in the list has to stay; four zeros are all that it keeps.
    if (isOfDraco) this.#add(new Uint8Array(4), {});
    else if (!compressed) this.#add(this.#bytesOf(view, `buffer view ${index}`), view);
    else {
      const others = Object.entries(extensions as Json).filter(([name]) => !meshopt.test(name));
      const kept = others.length > 0 ? { extensions: Object.fromEntries(others) } : {};
      this.#add(this.#decodeView(compressed, index), { ...rest, ...kept });
    }
  }

  #decodeView(compressed: Json, index: number): Uint8Array {
    const document = this.#document;
    const place = `buffer view ${index}`;
    const source = this.#bytesOf(compressed, place);
    const count = document.count(compressed.count, place);
    const stride = document.count(compressed.byteStride, place);
    document.spend(Math.ceil((count * stride) / 64), place);
    const target = new Uint8Array(count * stride);
    const filter = typeof compressed.filter === 'string' ? compressed.filter : undefined;
    this.#attempt(place, 'meshopt', () =>
      this.#decoders.meshopt!(target, count, stride, source, String(compressed.mode), filter),
    );
    return target;
  }

  #primitive(primitive: Record<string, unknown>, root: Json): void {
    const extension = dracoOf(primitive.extensions);
    if (!extension) return;
    const document = this.#document;
    const view = document.element('bufferViews', extension.bufferView, 'primitive');
    const place = `buffer view ${String(extension.bufferView)}`;
    const source = this.#bytesOf(view, place);
    const wanted = this.#attributes(primitive, extension, place);
    const mesh = this.#attempt(place, 'Draco', () => this.#decoders.draco!(source, wanted));
    wanted.forEach(({ accessor }, i) => {
      this.#store(root, accessor, mesh.attributes[i], mesh.vertices);
    });
    if (primitive.indices !== undefined) {
      document.element('accessors', primitive.indices, place);
      const accessor = primitive.indices as number;
      const bytes = new Uint8Array(mesh.indices.buffer);
      this.#store(root, accessor, bytes, mesh.indices.length, { componentType: 5125 });
    }
    const { [draco]: _, ...others } = primitive.extensions as Record<string, unknown>;
    if (Object.keys(others).length > 0) primitive.extensions = others;
    else delete primitive.extensions;
  }

  /** The attributes that a primitive has in its Draco data; it may have others that are not. */
  #attributes(primitive: Json, extension: Json, place: string) {
    const document = this.#document;
    const ids = document.record(extension.attributes, place);
    const attributes = document.record(primitive.attributes, place);
    return Object.entries(ids).flatMap(([name, id]) => {
      const accessor = attributes[name];
      if (typeof id !== 'number' || typeof accessor !== 'number') return [];
      const { componentType } = document.element('accessors', accessor, place);
      return [{ id, accessor, componentType: document.count(componentType, place) }];
    });
  }

  /** Gives an accessor a buffer view of its own. */
  #store(root: Json, index: number, bytes: Uint8Array, count: number, more: Json = {}): void {
    const accessor = (root.accessors as Record<string, unknown>[])[index];
    delete accessor.byteOffset;
    Object.assign(accessor, { bufferView: this.#views.length, count, ...more });
    this.#add(bytes, {});
  }

  #add(bytes: Uint8Array, view: Json): void {
    this.#views.push({ ...view, buffer: 0, byteOffset: this.#length, byteLength: bytes.length });
    this.#pieces.push(bytes);
    this.#length += 4 * Math.ceil(bytes.length / 4);
  }

  #bytesOf({ buffer, byteOffset, byteLength }: Json, place: string): Uint8Array {
    const document = this.#document;
    const bytes = document.buffer(document.count(buffer, place));
    const begin = document.count(byteOffset, place);
    const end = begin + document.count(byteLength, place);
    if (end <= bytes.length) return bytes.subarray(begin, end);
    const sentence = `it reaches to byte ${end} of a buffer that has ${bytes.length}; the file was cut off. Export it again.`;
    throw refusal('truncated-file', document.name, place, sentence);
  }

  #attempt<T>(place: string, what: Compression, decode: () => T): T {
    try {
      return decode();
    } catch {
      const sentence = `its ${what} data is broken; get the file again.`;
      throw refusal('malformed-file', this.#document.name, place, sentence);
    }
  }
}

function primitivesOf(document: GltfDocument): Json[] {
  return primitivesIn(document.root);
}

function primitivesIn(root: Json): Record<string, unknown>[] {
  const meshes = Array.isArray(root.meshes) ? root.meshes : [];
  return meshes.flatMap((mesh: unknown) => {
    const list = isRecord(mesh) ? mesh.primitives : undefined;
    return Array.isArray(list) ? list.filter(isRecord) : [];
  });
}

function dracoOf(extensions: unknown): Json | undefined {
  const extension = isRecord(extensions) ? extensions[draco] : undefined;
  return isRecord(extension) ? extension : undefined;
}

function meshoptOf(view: unknown): Json | undefined {
  if (!isRecord(view) || !isRecord(view.extensions)) return undefined;
  const found = Object.entries(view.extensions).find(([name]) => meshopt.test(name))?.[1];
  return isRecord(found) ? found : undefined;
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
