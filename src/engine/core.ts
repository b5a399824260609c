import type { MeshReport } from '../mesh/mesh.ts';
import type { ParameterValues } from '../methods/descriptor.ts';
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
  /** Validates and takes a welded mesh; forgets all that was there. */
  load(positions: Float64Array, triangles: Uint32Array): MeshReport;
  /** Chooses a method and its parameters (absent: default); handle vertices are welded vertices. Keeps the current positions. */
  configure(method: string, parameters: ParameterValues): void;
  /** Goes back to the rest positions. */
  restart(): void;
  /** Computes what the parameters made stale; costs nothing when nothing is. */
  prepare(): void;
  /** One iteration. */
  step(): Step;
  /** #V×3, in the file's units. */
  copyPositions(into: Float64Array): void;
  free(): void;
}

export interface Core {
  open(): CoreSession;
  /** The core's own method list, for the contract test. */
  methods(): unknown;
  /** Bytes of the wasm heap. */
  heapBytes(): number;
}
