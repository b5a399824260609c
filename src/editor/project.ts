import type { Picture } from '../../web/app/image-gallery.ts';
import type { Outcome, ReadResult, Solved } from '../engine/protocol.ts';
import type { Format } from '../io/index.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { ParameterValues } from '../methods/values/index.ts';

/** The file as it came. */
export interface Source {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly name: string;
  /** By the bytes: 'obj', 'glb', … */
  readonly format: Format;
  /** The normal map that it has inside, for the pictures. */
  readonly normalMap?: ReadResult['normalMap'];
}

/** What a run left. */
export interface Result {
  /** #P×3 in the file's frame and order. */
  readonly positions: Float64Array<ArrayBuffer>;
  /**
   * `settled` came from the file's own shape and is what anyone else gets from the same file and settings; `preview` followed
   * a moving slider and still has to be settled before it leaves the page; `stopped` is what a person chose to keep.
   */
  readonly state: 'settled' | 'preview' | 'stopped';
  readonly outcome: Outcome;
  readonly iterations: number;
  readonly energy: readonly number[];
  readonly milliseconds: number;
}

/** A style as the document holds it: enough to solve, to show which it is, and to say it in a recipe. Immutable. */
export interface ChosenStyle {
  /** Of its entry in the gallery, or `painted`. */
  readonly id: string;
  readonly name: string;
  /** What a recipe and the command line call it: a name of ours or a file. */
  readonly source: string;
  readonly map: GaussMap;
}

/** What is to be done to a mesh. */
export interface Shaping {
  readonly method: string;
  /** But for what the methods borrow: styles and the picture, which they get from here. */
  readonly parameters: ParameterValues;
  /** Kept while another method is chosen. Null until one was chosen. */
  readonly style: ChosenStyle | null;
  /** The same for methods that only take a few directions. */
  readonly directions: ChosenStyle | null;
  readonly picture: Picture | null;
}

/** The places for styles, named as the parameters are. */
export type StylePlace = 'style' | 'directions';

/** All that undo brings back. Immutable: a change is a new document. The camera is not in it. */
export interface WhittleDocument extends Shaping {
  readonly source: Source;
  readonly mesh: Mesh;
  readonly report: MeshReport;
  readonly result: Result | null;
}

/** What is to be seen of a document. */
export function shownPositions({ mesh, result }: WhittleDocument): Float64Array<ArrayBuffer> {
  return result?.positions ?? mesh.positions;
}

export function resultOf(solved: Solved, state: Result['state']): Result {
  const { positions, outcome, iterations, energy, milliseconds } = solved;
  return {
    positions,
    state,
    outcome,
    iterations,
    energy,
    milliseconds: milliseconds.prepare + milliseconds.solve,
  };
}

export function sameParameters(a: ParameterValues, b: ParameterValues): boolean {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...names].every((name) => a[name] === b[name]);
}

export function sameShaping(a: Shaping, b: Shaping): boolean {
  const sameStyles = a.style?.map === b.style?.map && a.directions?.map === b.directions?.map;
  const sameBorrowed = sameStyles && a.picture === b.picture;
  return a.method === b.method && sameBorrowed && sameParameters(a.parameters, b.parameters);
}

/** The same document with other settings: what it shows is now only a preview of them. */
export function withShaping(document: WhittleDocument, change: Partial<Shaping>): WhittleDocument {
  const { result } = document;
  return { ...document, ...change, result: result && { ...result, state: 'preview' } };
}
