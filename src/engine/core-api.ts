import type { MeshReport } from '../mesh/mesh.ts';
import type { EncodedValues } from './encode.ts';
import type { Outcome } from './protocol.ts';

/** What one step of a session says. */
export interface Step {
  readonly outcome: 'running' | Exclude<Outcome, 'cancelled'>;
  /** Energy before the step, in the unit frame. */
  readonly energy: number;
  /** Relative displacement of the step (2019, §3.1). */
  readonly change: number;
}

/** One mesh in the core. Every call throws a {@link WhittleError} with the core's own code and element. */
export interface CoreSession {
  /** Validates and takes a welded mesh (#V×3, #F×3); forgets all that was there. */
  load(positions: Float64Array, triangles: Uint32Array): MeshReport;
  /** Chooses a method and the values of its parameters (absent: default). Keeps the current positions. */
  configure(method: string, values: EncodedValues): void;
  /** Goes back to the rest positions. */
  restart(): void;
  /** Computes what the parameters made stale and starts a run from the current positions. */
  prepare(): void;
  /** One iteration. */
  step(): Step;
  /** Writes the current positions, #V×3 in the file's units. */
  copyPositions(into: Float64Array): void;
  free(): void;
}

/** One parameter as the core lists it. */
export interface CoreParameter {
  readonly name: string;
  readonly kind: string;
  readonly invalidates: string;
  /** Of a choice, the name. */
  readonly default?: number | string | boolean | readonly number[];
  readonly min?: number;
  readonly max?: number;
  /** Names of a choice; it crosses to the core as the index of one. */
  readonly choices?: readonly string[];
  /** How many rows of a matrix it takes at most in place of a name. */
  readonly maxRows?: number;
}

export interface Core {
  open(): CoreSession;
  /** The core's own method list, which a contract test holds against the descriptors. */
  methods(): readonly { readonly id: string; readonly parameters: readonly CoreParameter[] }[];
  /** Bytes of the wasm heap. */
  heapBytes(): number;
}
