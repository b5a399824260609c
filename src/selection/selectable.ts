import type { Mesh, Weld } from '../mesh/mesh.ts';
import { gather, weldOf } from '../mesh/weld.ts';
import { featuresOf, patchesOf } from './features.ts';
import { type Labels, labelled } from './labels.ts';
import { partsOf } from './parts.ts';
import { faceCount, type Topology, topologyOf } from './topology.ts';
import type { Work } from './work.ts';

/** A mesh in one of its shapes, as a person sees it: lines, smooth patches, parts. All that is selected is selected on one. */
export interface SelectableMesh {
  readonly topology: Topology;
  /** #V×3, the places of the welded vertices. */
  readonly places: Float64Array;
  /** #E, see {@link featuresOf}. */
  readonly features: Uint8Array;
  /** Of the faces, #S. */
  readonly patches: Labels;
  /** Of the vertices, #V. */
  readonly parts: Labels;
  /** Of the faces, #S: the parts that they belong to. */
  readonly facesOfParts: Labels;
  readonly visits: Visits;
}

export interface SelectableOptions {
  /** #P×3, the shape that is looked at. Default: the file's own. */
  readonly positions?: Float64Array;
  /** Degrees from which on an edge is a feature, default {@link defaultFeatureAngle}. */
  readonly angle?: number | undefined;
}

type Lasting = Pick<SelectableMesh, 'topology' | 'parts' | 'facesOfParts' | 'visits'>;

const known = new WeakMap<Weld, Lasting>();

/** What there is to select on a mesh. What does not hang on the shape is made once a file. */
export function* selectableOf(
  mesh: Mesh,
  { positions, angle }: SelectableOptions = {},
): Work<SelectableMesh> {
  const weld = weldOf(mesh);
  const lasting = known.get(weld) ?? (yield* lastingOf(weld));
  const { topology } = lasting;
  const places = gather(positions ?? mesh.positions, weld);
  yield;
  const features = yield* featuresOf(topology, places, angle);
  const patches = yield* patchesOf(topology, features);
  return { ...lasting, places, features, patches };
}

function* lastingOf(weld: Weld): Work<Lasting> {
  const topology = yield* topologyOf(weld);
  const parts = yield* partsOf(topology);
  const faces = faceCount(topology);
  const partOfFace = new Uint32Array(faces);
  for (let face = 0; face < faces; face++) partOfFace[face] = parts.of[topology.triangles[3 * face]!]!;
  const facesOfParts = labelled(partOfFace, parts.count);
  const lasting = { topology, parts, facesOfParts, visits: new Visits(topology.vertices, faces) };
  known.set(weld, lasting);
  return lasting;
}

/** Who was visited in the search that runs: a new search forgets all of them without touching any. */
export class Visits {
  readonly #vertices: Uint32Array;
  readonly #faces: Uint32Array;
  #search = 0;

  constructor(vertices: number, faces: number) {
    this.#vertices = new Uint32Array(vertices);
    this.#faces = new Uint32Array(faces);
  }

  begin(): void {
    this.#search++;
  }

  /** True the first time in a search. */
  vertex(v: number): boolean {
    if (this.#vertices[v] === this.#search) return false;
    this.#vertices[v] = this.#search;
    return true;
  }

  hasVertex(v: number): boolean {
    return this.#vertices[v] === this.#search;
  }

  hasFace(face: number): boolean {
    return this.#faces[face] === this.#search;
  }

  /** True the first time in a search. */
  face(face: number): boolean {
    if (this.#faces[face] === this.#search) return false;
    this.#faces[face] = this.#search;
    return true;
  }
}
