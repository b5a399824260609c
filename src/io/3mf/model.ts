import { identity, type Matrix } from '../gltf/matrix.ts';
import { FloatList, IndexList } from '../lists.ts';
import { quote, refusal } from '../refuse.ts';
import { XmlTags } from './xml.ts';

/** A mesh, or a group of other objects. */
export interface ModelObject {
  readonly id: string;
  readonly name: string;
  /** #V×3 in its own frame. */
  readonly positions: FloatList;
  /** #V×3 byte offsets of the values of x, y and z. */
  readonly offsets: IndexList;
  /** #F×3 */
  readonly triangles: IndexList;
  readonly components: Reference[];
  /** Its triangles have colours or materials. */
  hasProperties: boolean;
}

/** An object at a place. */
export interface Reference {
  readonly objectId: string;
  /** The model file that it is in, if it is another one. */
  readonly path: string | undefined;
  readonly transform: Matrix;
}

/** One model file of a 3MF archive. */
export interface Model {
  readonly path: string;
  readonly bytes: Uint8Array;
  /** In the order of the file. */
  readonly objects: ReadonlyMap<string, ModelObject>;
  /** What is to be printed, and where. */
  readonly items: readonly Reference[];
}

/** @throws malformed-file, truncated-file */
export function readModel(bytes: Uint8Array, path: string, name: string): Model {
  return new ModelReader(bytes, path, name).run();
}

class ModelReader {
  readonly #tags: XmlTags;
  readonly #path: string;
  readonly #name: string;
  readonly #objects = new Map<string, ModelObject>();
  readonly #items: Reference[] = [];
  #object: ModelObject | undefined;
  #isMesh = false;
  #isEnded = false;

  constructor(bytes: Uint8Array, path: string, name: string) {
    this.#tags = new XmlTags(bytes);
    this.#path = path;
    this.#name = name;
  }

  run(): Model {
    const tags = this.#tags;
    while (tags.next()) {
      if (tags.isEnd) this.#end();
      else this.#begin();
    }
    if (!this.#isEnded)
      throw this.#refusal('truncated-file', 'it ends too early; the file was cut off. Get it again.');
    return { path: this.#path, bytes: tags.bytes, objects: this.#objects, items: this.#items };
  }

  #begin(): void {
    const tags = this.#tags;
    switch (tags.name) {
      case 'vertex':
        if (this.#isMesh) this.#vertex();
        break;
      case 'triangle':
        if (this.#isMesh) this.#triangle();
        break;
      case 'mesh':
        this.#isMesh = this.#object !== undefined && !tags.isEmpty;
        break;
      case 'object':
        this.#beginObject();
        break;
      case 'component':
        this.#object?.components.push(this.#reference());
        break;
      case 'item':
        this.#items.push(this.#reference());
        break;
    }
  }

  #end(): void {
    const { name } = this.#tags;
    if (name === 'mesh') this.#isMesh = false;
    else if (name === 'object') this.#object = undefined;
    else if (name === 'model') this.#isEnded = true;
  }

  #beginObject(): void {
    const tags = this.#tags;
    const id = tags.get('id') ?? '';
    this.#object = {
      ...{ id, name: tags.get('name') ?? '', hasProperties: tags.get('pid') !== undefined },
      ...{ positions: new FloatList(), offsets: new IndexList(), triangles: new IndexList(), components: [] },
    };
    this.#objects.set(id, this.#object);
    if (tags.isEmpty) this.#object = undefined;
  }

  #vertex(): void {
    const tags = this.#tags;
    for (const axis of ['x', 'y', 'z']) {
      const span = tags.span(axis);
      const value = tags.number(axis);
      if (!span || (Number.isNaN(value) && !/^[+-]?nan/i.test(tags.get(axis)!))) {
        throw this.#malformed(`a vertex has the ${axis} ${quote(tags.get(axis) ?? '')}`);
      }
      this.#object!.positions.push(value);
      this.#object!.offsets.push(span[0]);
    }
  }

  #triangle(): void {
    const tags = this.#tags;
    const corners = ['v1', 'v2', 'v3'].map((corner) => tags.number(corner));
    const isIndex = (value: number) => Number.isInteger(value) && value >= 0 && value < 0xffffffff;
    if (!corners.every(isIndex)) throw this.#malformed('a triangle has no three vertices');
    this.#object!.triangles.push3(corners[0], corners[1], corners[2]);
    if (tags.span('pid')) this.#object!.hasProperties = true;
  }

  #reference(): Reference {
    const tags = this.#tags;
    const text = tags.get('transform');
    const numbers = text?.trim().split(/\s+/).map(Number) ?? [];
    if (text !== undefined && (numbers.length !== 12 || !numbers.every(Number.isFinite))) {
      throw this.#malformed('a transform has not twelve numbers');
    }
    // Rows there are columns here.
    const row = (i: number) => numbers.slice(3 * i, 3 * i + 3);
    const transform =
      text === undefined ? identity : [...row(0), 0, ...row(1), 0, ...row(2), 0, ...row(3), 1];
    return { objectId: tags.get('objectid') ?? '', path: tags.get('path'), transform };
  }

  #malformed(what: string): Error {
    return this.#refusal('malformed-file', `${what}; export the file again.`);
  }

  #refusal(code: 'malformed-file' | 'truncated-file', sentence: string): Error {
    return refusal(code, this.#name, `${this.#path}, byte ${this.#tags.start}`, sentence);
  }
}
