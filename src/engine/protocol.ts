import type { FilesBeside, Format, Reference, WrittenMesh } from '../io/index.ts';
import type { Failure } from '../mesh/failure.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import type { CoreField, CoreOutcome } from './core-api.ts';

/** How a run ended. A cancelled (or superseded) run keeps what it has. */
export type Outcome = CoreOutcome | 'cancelled';

/** Where a run begins: at the file's own shape, or at what the worker has now (the latest run on this mesh). */
export type Start = 'rest' | 'current';

export interface SolveSettings {
  readonly method: string;
  readonly parameters: ParameterValues;
  readonly start: Start;
  /** Whether progress carries positions; energies come either way. */
  readonly positions: boolean;
}

/** One look at a running solve. */
export type Progress = Preparing | Iterating;

/** The run prepares. */
export interface Preparing {
  readonly kind: 'preparing';
  /** What is being done, in a few words for people: "factoring the system". */
  readonly stage: string;
  /** From 0 to 1. */
  readonly share: number;
}

/** The run iterates. Iterations that passed since the last look are all in `energy` and `change`. */
export interface Iterating {
  readonly kind: 'iterating';
  /** Iterations done so far in this run. */
  readonly iteration: number;
  /** Energy before each iteration since the last look (in the unit frame, hence free of units). */
  readonly energy: readonly number[];
  /** Relative displacement of each iteration since the last look (2019, §3.1). */
  readonly change: readonly number[];
  /** #P×3 in the file's frame and order; absent when the run asked for none. */
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
  /** Sentences about what was repaired or ignored, and what the method has to say of its values. */
  readonly warnings: readonly string[];
  /** What the method can show besides the positions, see `Engine.field`. */
  readonly fields: readonly CoreField[];
}

export interface ReadResult {
  readonly mesh: Mesh;
  /** By the bytes, not by the name: 'obj', 'stl-binary', … */
  readonly format: Format;
  /** The normal map inside the file, as the bytes of an image. */
  readonly normalMap?: { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> };
  readonly warnings: readonly string[];
}

/** What each request takes and what it answers. Every message of the worker is declared here and nowhere else. */
export interface Calls {
  /** Understands a file. The bytes are copied, the caller keeps its own. */
  read: {
    ask: { bytes: Uint8Array<ArrayBuffer>; name: string; beside?: FilesBeside | undefined };
    answer: ReadResult;
  };
  /** The files that a file refers to, itself or by those beside it that are there already. */
  references: {
    ask: { bytes: Uint8Array<ArrayBuffer>; name: string; beside?: FilesBeside | undefined };
    answer: readonly Reference[];
  };
  /** Gives the source file back with other positions (and normals); another `format` than the source’s writes a new file. */
  write: {
    ask: {
      source: Uint8Array<ArrayBuffer>;
      name: string;
      format: string;
      positions: Float64Array<ArrayBuffer>;
      beside?: FilesBeside | undefined;
    };
    answer: WrittenMesh;
  };
  /** Makes a mesh known to the worker under a key and reports on it; the core's validation happens here. */
  load: { ask: { key: number; mesh: Mesh }; answer: MeshReport };
  /** Drops a mesh and all that was prepared for it. */
  unload: { ask: { key: number }; answer: null };
  solve: { ask: { key: number; settings: SolveSettings }; answer: Solved };
  /** A scalar field of the mesh's latest run, #P or #F. */
  field: { ask: { key: number; name: string }; answer: Float64Array<ArrayBuffer> };
}

export type CallName = keyof Calls;

export type Request = { [Name in CallName]: { type: Name; id: number } & Calls[Name]['ask'] }[CallName];

export type ToWorker =
  | Request
  /** Stop the request with this id at the next step; it still answers. */
  | { type: 'cancel'; id: number }
  /** The page has seen the latest progress of this run and wants the next; buffers travel back for reuse. */
  | { type: 'progress-seen'; id: number; positions?: Float64Array<ArrayBuffer> };

export type FromWorker =
  | { type: 'answer'; id: number; value: Calls[CallName]['answer'] }
  | { type: 'failure'; id: number; failure: Failure }
  | { type: 'progress'; id: number; progress: Progress }
  /** The core trapped and cannot be used any more. The last message of this worker, which closes itself. */
  | { type: 'lost'; failure: Failure };

/** Buffers that a message hands over instead of copying. The one place that knows. */
export function transferOf(message: ToWorker | FromWorker): ArrayBuffer[] {
  switch (message.type) {
    case 'progress': {
      const { progress } = message;
      return progress.kind === 'iterating' && progress.positions ? [progress.positions.buffer] : [];
    }
    case 'progress-seen':
      return message.positions ? [message.positions.buffer] : [];
    case 'answer':
      return buffersOf(message.value);
    default:
      return [];
  }
}

function isList(value: object): value is readonly unknown[] {
  return Array.isArray(value);
}

function buffersOf(value: Calls[CallName]['answer']): ArrayBuffer[] {
  if (value instanceof Float64Array) return [value.buffer];
  if (value === null || isList(value) || 'components' in value) return [];
  if ('bytes' in value) return [value.bytes.buffer];
  if ('positions' in value) return [value.positions.buffer];
  const { positions, triangles, weld, colors, uvs } = value.mesh;
  const { near, solved } = weld ?? {};
  const parts = [
    near?.positions,
    near?.offsets,
    solved?.triangles,
    solved?.faceOf,
    solved?.solvedOf,
    solved?.isTurned,
  ];
  const welded = [weld?.vertexOfPosition, weld?.positionOfVertex, weld?.triangles, ...parts];
  const arrays = [positions, triangles, ...welded, colors, uvs, value.normalMap?.bytes];
  return arrays.flatMap((array) => (array ? [array.buffer] : []));
}
