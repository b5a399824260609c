import type { Format } from '../io/index.ts';
import type { Failure } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { ParameterValues } from '../methods/values/index.ts';

/** How a run ended. A cancelled (or superseded) run keeps what it has. */
export type Outcome = 'converged' | 'iteration-limit' | 'stalled' | 'cancelled';

/** Where a run begins: at the file's own shape, or at what the worker has now (the latest run on this mesh). */
export type Start = 'rest' | 'current';

export interface SolveSettings {
  readonly method: string;
  readonly parameters: ParameterValues;
  readonly start: Start;
  /** Whether `frame` messages carry positions; energies and progress come either way. */
  readonly frames: boolean;
}

/** One look at a running solve. Iterations that passed since the last frame are all in `energy` and `change`. */
export interface Frame {
  /** Iterations done so far in this run. */
  readonly iteration: number;
  /** Energy before each iteration since the last frame (in the unit frame, hence free of units). */
  readonly energy: readonly number[];
  /** Relative displacement of each iteration since the last frame (2019, §3.1). */
  readonly change: readonly number[];
  /** #P×3 in the file's frame and order; absent when the run asked for no frames. */
  readonly positions?: Float64Array<ArrayBuffer>;
}

export interface Solved {
  readonly outcome: Outcome;
  readonly iterations: number;
  /** Energy per iteration of the whole run. */
  readonly energy: readonly number[];
  /** #P×3 in the file's frame and order. */
  readonly positions: Float64Array<ArrayBuffer>;
  readonly milliseconds: { readonly prepare: number; readonly solve: number };
  /** Sentences about what was repaired or ignored. */
  readonly warnings: readonly string[];
}

export interface ReadResult {
  readonly mesh: Mesh;
  /** By the bytes, not by the name: 'obj', 'stl-binary', … */
  readonly format: Format;
  /** The normal map inside the file, as the bytes of a picture. */
  readonly normalMap?: { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> };
  readonly warnings: readonly string[];
}

/** What each request takes and what it answers. Every message of the worker is declared here and nowhere else. */
export interface Calls {
  /** Understands a file. The bytes are copied, the caller keeps its own. */
  read: { ask: { bytes: Uint8Array<ArrayBuffer>; name: string }; answer: ReadResult };
  /** Gives the source file back with other positions (and normals); another `format` than the source’s writes a new file. */
  write: {
    ask: {
      source: Uint8Array<ArrayBuffer>;
      name: string;
      format: string;
      positions: Float64Array<ArrayBuffer>;
    };
    answer: Uint8Array<ArrayBuffer>;
  };
  /** Makes a mesh known to the worker under a key and reports on it; the core's validation happens here. */
  load: { ask: { key: number; mesh: Mesh }; answer: MeshReport };
  /** Drops a mesh and all that was prepared for it. */
  unload: { ask: { key: number }; answer: null };
  solve: { ask: { key: number; settings: SolveSettings }; answer: Solved };
}

export type CallName = keyof Calls;

export type Request = { [Name in CallName]: { type: Name; id: number } & Calls[Name]['ask'] }[CallName];

export type ToWorker =
  | Request
  /** Stop the request with this id at the next step; it still answers. */
  | { type: 'cancel'; id: number }
  /** The page has drawn the last frame of this run and wants the next one; buffers travel back for reuse. */
  | { type: 'frame-drawn'; id: number; positions?: Float64Array<ArrayBuffer> };

export type FromWorker =
  | { type: 'answer'; id: number; value: Calls[CallName]['answer'] }
  | { type: 'failure'; id: number; failure: Failure }
  | { type: 'frame'; id: number; frame: Frame }
  /** The core trapped and cannot be used any more. The last message of this worker, which closes itself. */
  | { type: 'lost'; failure: Failure };

/** Buffers that a message hands over instead of copying. The one place that knows. */
export function transferOf(message: ToWorker | FromWorker): ArrayBuffer[] {
  switch (message.type) {
    case 'frame':
      return message.frame.positions ? [message.frame.positions.buffer] : [];
    case 'frame-drawn':
      return message.positions ? [message.positions.buffer] : [];
    case 'answer':
      return buffersOf(message.value);
    default:
      return [];
  }
}

function buffersOf(value: Calls[CallName]['answer']): ArrayBuffer[] {
  if (value instanceof Uint8Array) return [value.buffer];
  if (value === null || 'components' in value) return [];
  if ('positions' in value) return [value.positions.buffer];
  const { positions, triangles, weld, colors, uvs } = value.mesh;
  const welded = [weld?.vertexOfPosition, weld?.positionOfVertex, weld?.triangles];
  const arrays = [positions, triangles, ...welded, colors, uvs, value.normalMap?.bytes];
  return arrays.flatMap((array) => (array ? [array.buffer] : []));
}
