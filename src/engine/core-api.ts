import type { MeshReport } from '../mesh/mesh.ts';
import type { EncodedValues } from './encode.ts';

/** How the core ends a run. */
export type CoreOutcome = 'converged' | 'iteration-limit' | 'stalled';

/** What one step of a session says. */
export interface Step {
  /** `midway`: of an iteration that takes long; there is nothing to report yet, and the next step goes on with it. */
  readonly outcome: 'running' | 'midway' | CoreOutcome;
  /** Energy before the step, in the unit frame. */
  readonly energy: number;
  /** Relative displacement of the step (2019, §3.1). */
  readonly change: number;
}

/** How far preparing is. */
export interface Preparation {
  /** What was done just now, in a few words for people: "factoring the system". */
  readonly stage: string;
  /** From 0 to 1; at 1 the run is ready. */
  readonly share: number;
}

/** What a method knows besides the positions: a number for each vertex or face, or lines over the mesh. */
export interface CoreField {
  readonly name: string;
  readonly label: string;
  /** Numbers of lines are vertices, two for each. */
  readonly per: 'vertex' | 'face' | 'line';
  readonly unit: string;
  /** How many lines there are; numbers know theirs. */
  readonly count?: number;
}

/** What the core says of a mesh: all but what the weld knows. */
export type CoreReport = Omit<MeshReport, 'nearPlaces' | 'duplicateFaces' | 'turnedFaces' | 'oneSidedEdges'>;

/** One mesh in the core. Every call throws a {@link WhittleError} with the core's own code and element. */
export interface CoreSession {
  /**
   * Validates and takes a welded mesh (#V×3, #F×3); forgets all that was there.
   *
   * @param sourceVertices #V, what the file numbers each vertex; sentences and elements of refusals speak of these. Default: the same
   * @param sourceFaces #F, what the file numbers each face, likewise
   */
  load(
    positions: Float64Array,
    triangles: Uint32Array,
    sourceVertices?: Uint32Array,
    sourceFaces?: Uint32Array,
  ): CoreReport;
  /** Chooses a method and the values of its parameters (absent: default). Keeps the current positions. */
  configure(method: string, values: EncodedValues): void;
  /** Goes back to the rest positions. */
  restart(): void;
  /** Does one stage of computing what the values made stale, or some of it; after the last a run starts from the current positions. */
  prepareNext(): Preparation;
  /** One iteration. */
  step(): Step;
  /** Writes the current positions, #V×3 in the file's units. */
  copyPositions(into: Float64Array): void;
  /** What a person should know of the chosen values on this mesh, a sentence each. */
  warnings(): string[];
  /** What the prepared method can show besides the positions. */
  fields(): readonly CoreField[];
  /** Writes a field, #V or #F, or the vertices of lines, #×2. */
  copyField(name: string, into: Float64Array): void;
  free(): void;
}

/** One parameter as the core lists it. */
export interface CoreParameter {
  readonly name: string;
  readonly kind: string;
  readonly invalidates: string;
  /** The value that it has unless it is set; a choice says it by its name. */
  readonly default?: number | string | boolean | readonly number[];
  readonly min?: number;
  readonly max?: number;
  /** Names of a choice. */
  readonly choices?: readonly string[];
  /** How many rows of a matrix it takes at most in place of a name. */
  readonly maxRows?: number;
}

/** A method as the core lists it. */
export interface CoreMethod {
  readonly id: string;
  readonly parameters: readonly CoreParameter[];
}

export interface Core {
  open(): CoreSession;
  /** The core's own method list, which a contract test holds against the descriptors. */
  methods(): readonly CoreMethod[];
  /** Bytes of the wasm heap. */
  heapBytes(): number;
}
