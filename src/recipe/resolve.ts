import type { Engine } from '../engine/client.ts';
import type { ReadResult } from '../engine/protocol.ts';
import { readSphereField, sphereFieldOfImage } from '../inputs/fields/read-sphere-field.ts';
import type { Image } from '../inputs/images/image.ts';
import { layTexture } from '../inputs/images/lay.ts';
import { patternIds } from '../inputs/images/patterns.ts';
import { decodePng, readTexture, rememberedTexture } from '../inputs/images/read.ts';
import type { Texture, TextureOptions } from '../inputs/images/texture.ts';
import type { TextureSlopesOptions } from '../inputs/images/texture-slopes.ts';
import { readStyle } from '../inputs/styles/read-style.ts';
import { type Mapping, resolveStyle } from '../inputs/styles/resolve.ts';
import { at, WhittleError } from '../mesh/failure.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { findMethod } from '../methods/registry.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { ParameterValue, ParameterValues } from '../methods/values/index.ts';
import type { Directions } from '../methods/values/points.ts';
import type { SphereField } from '../methods/values/sphere-field.ts';
import type { StyleParameter } from '../methods/values/style.ts';
import type { RecipeStep } from './recipe.ts';

/** A mesh, and the normal map that its file has inside. */
export interface TexturedMesh {
  readonly mesh: Mesh;
  readonly normalMap?: ReadResult['normalMap'];
}

/** Something that a recipe names and that is at hand already: it was painted, dropped or read before. Immutable. */
export type Asset = (
  | { readonly kind: 'gauss-map'; readonly map: GaussMap }
  | { readonly kind: 'mesh'; readonly mesh: Mesh }
  | { readonly kind: 'image'; readonly image: Image }
  | { readonly kind: 'sphere-field'; readonly field: SphereField }
) & {
  /** The file that it was read from; what was painted has none. */
  readonly file?: Uint8Array<ArrayBuffer>;
};

/** Where the names in a recipe lead. */
export interface Surroundings {
  /** The bytes of a file that a recipe names. Default: there are none. @throws Error whose sentence begins with the name */
  readonly readFile?: (name: string) => Promise<Uint8Array<ArrayBuffer>>;
  /** Default: PNG only. @throws WhittleError */
  readonly decodeImage?: (bytes: Uint8Array<ArrayBuffer>, name: string) => Promise<Image>;
  /** What has a name here; it comes before files and names of ours. */
  readonly asset?: (name: string) => Asset | undefined;
}

/** A step as the engine takes it, and sentences about what came of its names. */
export interface ResolvedStep {
  readonly method: string;
  readonly parameters: ParameterValues;
  readonly warnings: readonly string[];
}

/** Sees a style mesh on its way to the sphere. */
export type FlowListener = (mesh: Mesh, positions: Float64Array) => void;

/**
 * Turns the names in the steps of recipes into what the engine takes: styles into Gauss maps, images into slopes on the mesh.
 * It remembers what it made, so that a step that is run again and again is resolved once.
 */
export class Resolver {
  readonly #engine: Engine;
  readonly #surroundings: Required<Surroundings>;
  readonly #maps = new Map<string, Promise<GaussMap>>();
  readonly #mapsOfAssets = new WeakMap<Asset, Promise<GaussMap>>();
  readonly #images = new WeakMap<Uint8Array, Promise<Image>>();
  readonly #fields = new Map<string, Promise<SphereField>>();
  readonly #fieldsOfAssets = new WeakMap<Asset, Promise<SphereField>>();

  constructor(engine: Engine, surroundings: Surroundings = {}) {
    this.#engine = engine;
    this.#surroundings = {
      readFile: noFile,
      decodeImage: decodePng,
      asset: () => undefined,
      ...surroundings,
    };
  }

  /**
   * @param place what sentences about the mesh begin with
   * @throws WhittleError for a name that is none, a file that cannot be used, and a mesh that an image does not fit
   */
  async resolve(step: RecipeStep, surface: TexturedMesh, place = ''): Promise<ResolvedStep> {
    const values: Record<string, ParameterValue> = { ...step.parameters };
    const warnings: string[] = [];
    for (const descriptor of findMethod(step.method)?.parameters ?? []) {
      const { name, kind } = descriptor;
      if (kind === 'style') values[name] = await this.#styleOf(descriptor, step.parameters);
      if (kind === 'sphereField' && typeof values[name] === 'string')
        values[name] = await this.#fieldOf(values[name] as string);
      if (kind !== 'textureSlopes' || typeof (values[name] ?? '') !== 'string') continue;
      const texture = await this.#textureOf(values[name] as string | undefined, step.parameters, surface);
      const { repeat } = step.parameters as TextureSlopesOptions;
      const { slopes, remark } = await at(place, () => layTexture(texture, surface.mesh, { repeat }));
      values[name] = slopes;
      if (remark !== undefined) warnings.push(remark);
    }
    return { method: step.method, parameters: values, warnings };
  }

  /**
   * The Gauss map of a style.
   *
   * @param given what a recipe may say
   * @param onFlow sees the way to the sphere of a style that is read through it, if it is not known yet
   * @throws WhittleError with a sentence about the style; it is tried anew the next time
   */
  gaussMap(
    parameter: StyleParameter,
    given: string | Directions,
    mapping: Mapping,
    onFlow?: FlowListener,
  ): Promise<GaussMap> {
    const flow = (mesh: Mesh) => this.#flow(mesh, onFlow);
    const readMesh = async (bytes: Uint8Array<ArrayBuffer>, name: string) =>
      (await this.#engine.read(bytes, name)).mesh;
    const read = () =>
      readStyle(parameter, { given, mapping }, { readFile: this.#surroundings.readFile, readMesh, flow });
    if (typeof given !== 'string') return read();
    const asset = this.#surroundings.asset(given);
    if (asset) return remembered(this.#mapsOfAssets, asset, () => mapOfAsset(asset, given, mapping, flow));
    return remembered(this.#maps, `${parameter.mapping ?? ''} ${mapping} ${given}`, read);
  }

  async #styleOf(parameter: StyleParameter, values: ParameterValues): Promise<GaussMap> {
    const { [parameter.name]: value = parameter.default, mapping = parameter.mapping ?? 'auto' } = values;
    if (typeof value !== 'string' && !Array.isArray(value)) return value as GaussMap;
    return this.gaussMap(parameter, value as string | Directions, mapping as Mapping);
  }

  /** A field that is a file is read once, as long as it is read from the same place. */
  #fieldOf(given: string): Promise<SphereField> {
    const asset = this.#surroundings.asset(given);
    if (!asset) return remembered(this.#fields, given, () => readSphereField(given, this.#surroundings));
    return remembered(this.#fieldsOfAssets, asset, async () => fieldOfAsset(asset, given));
  }

  async #textureOf(
    given: string | undefined,
    values: ParameterValues,
    { normalMap }: TexturedMesh,
  ): Promise<Texture> {
    const { reading, green } = values as TextureOptions;
    const options = { reading, green };
    const asset = given === undefined ? undefined : this.#surroundings.asset(given);
    if (asset?.kind === 'image') return rememberedTexture(asset.image, given!, options);
    if (given !== undefined) return readTexture(given, this.#surroundings, options);
    if (!normalMap) throw noImage();
    const { bytes, name } = normalMap;
    const place = `The file’s own normal map “${name}”`;
    const image = await remembered(this.#images, bytes, () => this.#surroundings.decodeImage(bytes, place));
    return rememberedTexture(image, place, options);
  }

  async #flow(mesh: Mesh, onFlow?: FlowListener): Promise<Float64Array> {
    const settings = { method: 'spherical', parameters: {}, start: 'rest', positions: !!onFlow } as const;
    try {
      const { positions } = await this.#engine.solve(mesh, settings, {
        onProgress: (progress) => {
          if (progress.kind === 'iterating' && progress.positions) onFlow?.(mesh, progress.positions);
        },
      });
      onFlow?.(mesh, positions);
      return positions;
    } finally {
      this.#engine.release(mesh);
    }
  }
}

async function mapOfAsset(
  asset: Asset,
  name: string,
  mapping: Mapping,
  flow: (mesh: Mesh) => Promise<Float64Array>,
): Promise<GaussMap> {
  if (asset.kind === 'gauss-map') return asset.map;
  if (asset.kind === 'mesh') return at(name, () => resolveStyle(asset.mesh, mapping, flow));
  throw new WhittleError('bad-parameter', `${name} is a picture and no style; choose a shape.`);
}

function fieldOfAsset(asset: Asset, name: string): SphereField {
  if (asset.kind === 'sphere-field') return asset.field;
  if (asset.kind === 'image') return sphereFieldOfImage(asset.image, name);
  throw new WhittleError('bad-parameter', `${name} is a shape and no field; choose a grey picture.`);
}

interface Memory<Key, Value> {
  get(key: Key): Promise<Value> | undefined;
  set(key: Key, value: Promise<Value>): unknown;
  delete(key: Key): unknown;
}

/** The promise that was made for a key before, or a new one. One that fails is forgotten. */
function remembered<Key, Value>(
  memory: Memory<Key, Value>,
  key: Key,
  make: () => Promise<Value>,
): Promise<Value> {
  const known = memory.get(key);
  if (known) return known;
  const made = make();
  memory.set(key, made);
  made.catch(() => memory.delete(key));
  return made;
}

async function noFile(name: string): Promise<never> {
  throw new WhittleError('bad-recipe', `${name}: there is no such file here; hand over what reads files.`);
}

function noImage(): WhittleError {
  return new WhittleError(
    'bad-parameter',
    `normalmap needs an image; give as “image” a PNG, such as map.png, or a pattern: ${patternIds.join(', ')}.`,
  );
}
