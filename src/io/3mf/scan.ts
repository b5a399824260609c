import { apply3, identity, isMirrored, linearPart, type Matrix, multiply } from '../gltf/matrix.ts';
import { FloatList, IndexList } from '../lists.ts';
import type { Look } from '../look/look.ts';
import { type ParsedFile, triangleFaces } from '../parsed-file.ts';
import { settlePlaceless } from '../placeless.ts';
import { counted, quote, refusal } from '../refuse.ts';
import { readZip, unpack, type ZipEntry } from '../zip.ts';
import { type Model, type ModelObject, type Reference, readModel } from './model.ts';
import { XmlTags } from './xml.ts';

/** An object of a model file at its place. */
export interface ThreeMfPart {
  readonly model: Model;
  readonly object: ModelObject;
  /** Index of its first vertex among all positions. */
  readonly first: number;
  readonly firstFace: number;
  readonly toWorld: Matrix;
}

/** A 3MF archive as one mesh in the frame of the build plate. */
export interface ThreeMfFile extends ParsedFile {
  readonly entries: readonly ZipEntry[];
  readonly parts: readonly ThreeMfPart[];
}

/** Objects may hold objects so deep, and not each other. */
const deepest = 64;

/** Whether an archive is a 3MF, by the names of its files. */
export function hasModel(bytes: Uint8Array, name: string): boolean {
  return readZip(bytes, name).some((entry) => isModelPath(entry.name));
}

/**
 * Reads 3MF: all objects that are to be printed, each at its first place on the plate; those of other model files in the archive
 * too (the production extension). Where a transform mirrors, triangles are read the other way round.
 *
 * @throws no-faces, index-out-of-range, malformed-file, truncated-file, not-finite, unsupported-file, too-large
 */
export function scan3mf(bytes: Uint8Array, name: string): ThreeMfFile {
  return new ThreeMfScan(bytes, name).run();
}

/** Names of objects; their colours no other format gets. */
export function lookOf3mf(_bytes: Uint8Array, { parts }: ThreeMfFile): Look {
  const hasColors = parts.some(({ object }) => object.hasProperties);
  return {
    parts: parts.map(({ firstFace, object }) => ({ firstFace, name: object.name })),
    materials: [],
    besides: hasColors ? ['colours and materials of its faces'] : [],
  };
}

class ThreeMfScan {
  readonly #name: string;
  readonly #entries: readonly ZipEntry[];
  readonly #models = new Map<string, Model>();
  readonly #parts: ThreeMfPart[] = [];
  readonly #taken = new Set<ModelObject>();
  readonly #positions = new FloatList();
  readonly #corners = new IndexList();
  #repeated = 0;

  constructor(bytes: Uint8Array, name: string) {
    this.#name = name;
    this.#entries = readZip(bytes, name);
  }

  run(): ThreeMfFile {
    const main = this.#model(this.#mainPath());
    const items = main.items.length > 0 ? main.items : allObjects(main);
    for (const item of items) this.#place(item, main, identity, 0);
    const corners = this.#corners.take();
    if (corners.length === 0) {
      throw refusal(
        'no-faces',
        this.#name,
        '',
        'it has no triangles to print; export it as a mesh with faces.',
      );
    }
    const positions = this.#positions.take();
    const { placeless, warnings } = settlePlaceless(positions, corners, (p) => this.#notFinite(p));
    return {
      entries: this.#entries,
      parts: this.#parts,
      positions,
      ...(placeless ? { placeless } : {}),
      faces: triangleFaces(corners),
      warnings: [...this.#copies(), ...warnings],
    };
  }

  /** The model that the archive begins with: as its relations say, or else the first. */
  #mainPath(): string {
    const relations = this.#entry('_rels/.rels');
    if (relations) {
      const tags = new XmlTags(unpack(relations, this.#name));
      while (tags.next()) if (/3dmodel$/i.test(tags.get('Type') ?? '')) return tags.get('Target') ?? '';
    }
    return this.#entries.find((entry) => isModelPath(entry.name))?.name ?? '';
  }

  #model(path: string): Model {
    const entry = this.#entry(path);
    if (!entry) throw this.#malformed(quote(path), 'there is no such model in the archive');
    const known = this.#models.get(entry.name);
    if (known) return known;
    const model = readModel(unpack(entry, this.#name), entry.name, this.#name);
    this.#models.set(entry.name, model);
    return model;
  }

  /** Paths begin at the archive, and differ in capitals at times. */
  #entry(path: string): ZipEntry | undefined {
    const plain = (text: string) => text.replace(/^\//, '').toLowerCase();
    return this.#entries.find(({ name }) => plain(name) === plain(path));
  }

  #place({ objectId, path, transform }: Reference, from: Model, parent: Matrix, depth: number): void {
    const model = path === undefined ? from : this.#model(path);
    const object = model.objects.get(objectId);
    if (!object) throw this.#malformed(model.path, `there is no object ${quote(objectId)}`);
    if (depth > deepest) throw this.#malformed(model.path, `object ${quote(objectId)} contains itself`);
    const toWorld = multiply(parent, transform);
    if (object.triangles.length > 0) this.#add(model, object, toWorld);
    // The parts of an object that stands here already do too.
    if (object.components.length > 0 && this.#taken.has(object)) this.#repeated++;
    else for (const component of object.components) this.#place(component, model, toWorld, depth + 1);
    this.#taken.add(object);
  }

  #add(model: Model, object: ModelObject, toWorld: Matrix): void {
    if (this.#taken.has(object)) {
      this.#repeated++;
      return;
    }
    const first = this.#positions.length / 3;
    this.#parts.push({ model, object, first, firstFace: this.#corners.length / 3, toWorld });
    const local = object.positions.take();
    const linear = linearPart(toWorld);
    const world = new Float64Array(3);
    for (let i = 0; i < local.length; i += 3) {
      apply3(linear, local[i], local[i + 1], local[i + 2], world, 0);
      this.#positions.push3(world[0] + toWorld[12], world[1] + toWorld[13], world[2] + toWorld[14]);
    }
    const corners = object.triangles.take();
    const bad = corners.findIndex((vertex) => 3 * vertex >= local.length);
    if (bad >= 0) throw this.#outOfRange(model, object, corners[bad]);
    const isTurned = isMirrored(toWorld);
    for (let c = 0; c < corners.length; c += 3) {
      const [a, b, d] = [first + corners[c], first + corners[c + 1], first + corners[c + 2]];
      this.#corners.push3(a, isTurned ? d : b, isTurned ? b : d);
    }
  }

  #copies(): string[] {
    if (this.#repeated === 0) return [];
    const what = counted(this.#repeated, 'copy', 'copies');
    return [
      `Some objects stand on the plate several times; they are edited at their first place, and ${what} will follow.`,
    ];
  }

  #notFinite(p: number): Error {
    const { model, object, first } = this.#parts.findLast((part) => part.first <= p)!;
    const sentence = `vertex ${p - first} has a coordinate that is not finite; repair the mesh and export it again.`;
    return refusal('not-finite', this.#name, `${model.path}, object ${object.id}`, sentence, p - first);
  }

  #outOfRange(model: Model, object: ModelObject, vertex: number): Error {
    const sentence = `a triangle uses vertex ${vertex}, but there are only ${object.positions.length / 3}; export the file again.`;
    return refusal('index-out-of-range', this.#name, `${model.path}, object ${object.id}`, sentence, vertex);
  }

  #malformed(place: string, what: string): Error {
    return refusal('malformed-file', this.#name, place, `${what}; export the file again.`);
  }
}

function isModelPath(path: string): boolean {
  return /\.model$/i.test(path);
}

/** Where nothing is said of printing, all that is no part of something else. */
function allObjects({ objects }: Model): Reference[] {
  const inner = new Set(
    [...objects.values()].flatMap(({ components }) => components.map(({ objectId }) => objectId)),
  );
  const outer = [...objects.keys()].filter((id) => !inner.has(id));
  return outer.map((objectId) => ({ objectId, path: undefined, transform: identity }));
}
