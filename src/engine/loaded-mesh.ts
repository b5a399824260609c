import { WhittleError } from '../mesh/failure.ts';
import type { Mesh, MeshReport, Weld } from '../mesh/mesh.ts';
import { gather, spread, weldOf } from '../mesh/weld.ts';
import type { Core, CoreSession, Step } from './core-api.ts';
import type { EncodedValues } from './encode.ts';
import { inCore } from './trap.ts';

/**
 * A mesh in the core together with the way back to its file: answers and refusals are in the file's numbering.
 *
 * Every call throws what the core refused as a `WhittleError`, and a `CoreTrap` if the core broke.
 */
export class LoadedMesh {
  readonly weld: Weld;
  readonly report: MeshReport;
  readonly #core: Core;
  readonly #session: CoreSession;
  readonly #scratch: Float64Array<ArrayBuffer>;
  readonly #length: number;

  constructor(core: Core, mesh: Mesh) {
    this.weld = weldOf(mesh);
    const positions = gather(mesh.positions, this.weld);
    this.#core = core;
    this.#length = mesh.positions.length;
    this.#scratch = new Float64Array(positions.length);
    this.#session = this.#call(() => core.open());
    try {
      this.report = this.#call(() => this.#session.load(positions, this.weld.triangles));
    } catch (thrown) {
      if (thrown instanceof WhittleError) this.free();
      throw thrown;
    }
  }

  prepare(method: string, values: EncodedValues, fromRest: boolean): void {
    this.#call(() => {
      this.#session.configure(method, values);
      if (fromRest) this.#session.restart();
      this.#session.prepare();
    });
  }

  step(): Step {
    return this.#call(() => this.#session.step());
  }

  restart(): void {
    this.#call(() => this.#session.restart());
  }

  /** #P×3 in file order; `into` is used again if it fits. */
  readonly copyPositions = (into?: Float64Array<ArrayBuffer>): Float64Array<ArrayBuffer> => {
    this.#call(() => this.#session.copyPositions(this.#scratch));
    const fits = into?.length === this.#length;
    return spread(this.#scratch, this.weld, fits ? into : undefined);
  };

  free(): void {
    this.#call(() => this.#session.free());
  }

  #call<T>(call: () => T): T {
    try {
      return inCore(call, () => this.#core.heapBytes());
    } catch (thrown) {
      throw thrown instanceof WhittleError ? asSentence(inFileNumbers(thrown, this.weld)) : thrown;
    }
  }
}

/**
 * The core counts welded vertices. Where its sentence speaks of "vertex N", N being its element, both become the first
 * position of the file that is this vertex. Faces keep their numbers: welding leaves them in their order.
 */
export function inFileNumbers(error: WhittleError, { positionOfVertex }: Weld): WhittleError {
  const { code, message, element } = error;
  if (element === undefined) return error;
  const words = new RegExp(`\\b(vertex) ${element}\\b`, 'gi');
  const source = positionOfVertex[element];
  if (source === undefined || !words.test(message)) return error;
  return new WhittleError(code, message.replace(words, `$1 ${source}`), source);
}

/** The core's messages have neither capital nor full stop. */
function asSentence({ code, message, element }: WhittleError): WhittleError {
  const sentence = message.charAt(0).toUpperCase() + message.slice(1);
  return new WhittleError(code, /[.!?]$/.test(sentence) ? sentence : `${sentence}.`, element);
}
