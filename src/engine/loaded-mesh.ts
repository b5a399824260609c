import { WhittleError } from '../mesh/failure.ts';
import type { Mesh, MeshReport, Weld } from '../mesh/mesh.ts';
import { gather, solvedTriangles, spread, weldOf } from '../mesh/weld.ts';
import type { Core, CoreField, CoreReport, CoreSession, Preparation, Step } from './core-api.ts';
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
  /** A run was overtaken while it prepared, and none has made a step since. */
  isOverdue = false;
  readonly #core: Core;
  readonly #session: CoreSession;
  readonly #scratch: Float64Array<ArrayBuffer>;
  readonly #source: Float64Array;

  constructor(core: Core, mesh: Mesh) {
    this.weld = weldOf(mesh);
    const positions = gather(mesh.positions, this.weld);
    this.#core = core;
    this.#source = mesh.positions;
    this.#scratch = new Float64Array(positions.length);
    this.#session = this.#call(() => core.open());
    try {
      const report = this.#call(() =>
        this.#session.load(
          positions,
          solvedTriangles(this.weld),
          this.weld.positionOfVertex,
          this.weld.solved?.faceOf,
        ),
      );
      this.report = { ...report, ...ofWeld(this.weld) };
    } catch (thrown) {
      if (thrown instanceof WhittleError) this.free();
      throw thrown;
    }
  }

  /** Chooses a method and its values; what they make stale is for {@link prepareNext}. */
  configure(method: string, values: EncodedValues, fromRest: boolean): void {
    this.#call(() => {
      this.#session.configure(method, values);
      if (fromRest) this.#session.restart();
    });
  }

  prepareNext(): Preparation {
    return this.#call(() => this.#session.prepareNext());
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
    const fits = into?.length === this.#source.length;
    return spread(this.#scratch, this.weld, this.#source, fits ? into : undefined);
  };

  warnings(): string[] {
    return this.#call(() => this.#session.warnings());
  }

  fields(): readonly CoreField[] {
    return this.#call(() => this.#session.fields());
  }

  /** A field of the prepared method: #P in file order for one by vertex, #F for one by face, for lines #×2 positions of the file. */
  field(name: string): Float64Array<ArrayBuffer> {
    const field = this.fields().find((known) => known.name === name);
    if (!field) throw new WhittleError('bad-parameter', `There is no field “${name}” to show.`);
    const faces = solvedTriangles(this.weld).length / 3;
    const sizes = { vertex: this.report.vertices, face: faces, line: 2 * (field.count ?? 0) };
    const values = new Float64Array(sizes[field.per]);
    this.#call(() => this.#session.copyField(name, values));
    const { solved, positionOfVertex } = this.weld;
    if (field.per === 'line') return values.map((vertex) => positionOfVertex[vertex]!);
    if (field.per === 'face')
      return solved ? Float64Array.from(solved.solvedOf, (face) => values[face]!) : values;
    return Float64Array.from(this.weld.vertexOfPosition, (vertex) => values[vertex]!);
  }

  free(): void {
    this.#call(() => this.#session.free());
  }

  #call<T>(call: () => T): T {
    try {
      return inCore(call, () => this.#core.heapBytes());
    } catch (thrown) {
      throw thrown instanceof WhittleError ? asSentence(thrown) : thrown;
    }
  }
}

/** What the weld knows and the core does not see. */
function ofWeld({ triangles, near, solved }: Weld): Omit<MeshReport, keyof CoreReport> & { faces: number } {
  return {
    faces: triangles.length / 3,
    nearPlaces: near?.places ?? 0,
    duplicateFaces: solved?.repeated ?? 0,
    turnedFaces: solved?.turned ?? 0,
    oneSidedEdges: solved?.oneSidedEdges ?? 0,
  };
}

/** The core's messages have neither capital nor full stop. */
function asSentence({ code, message, element }: WhittleError): WhittleError {
  const sentence = message.charAt(0).toUpperCase() + message.slice(1);
  return new WhittleError(code, /[.!?]$/.test(sentence) ? sentence : `${sentence}.`, element);
}
