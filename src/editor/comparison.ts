import type { Engine } from '../engine/client.ts';
import { toFailure } from '../mesh/failure.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { movedMesh } from '../mesh/weld.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import { type Resolver, runStep } from '../recipe/index.ts';
import {
  activeStep,
  inputsOf,
  type Project,
  type Result,
  restShapeOf,
  resultOf,
  type StepInputs,
  sameInputs,
} from './project.ts';
import type { EditorState } from './state.ts';
import { patiently } from './task.ts';

export interface ComparisonParts {
  readonly store: { readonly state: EditorState; subscribe(listener: () => void): () => void };
  readonly engine: Engine;
  readonly resolver: Resolver;
  /** Whether a gesture is under way, as of the editor. */
  readonly isFollowing: () => boolean;
  /** Draws a shape (#P×3) of a picture; resolves when it has been seen. */
  readonly draw: (picture: number, positions: Float64Array) => Promise<void>;
  /** What is said of a picture has changed. */
  readonly changed: () => void;
}

/** The active step with another value of one parameter, and what that gives. */
export interface Picture {
  readonly value: string;
  readonly result: Result | null;
  readonly isRunning: boolean;
  /** Why there is no result, as a sentence. */
  readonly failure: string | null;
}

interface Place extends Picture {
  readonly value: string;
  result: Result | null;
  isRunning: boolean;
  failure: string | null;
  /** What the failure was one of. */
  failedAt: StepInputs | null;
  /** The step's rest shape, under a key of its own for the engine. */
  mesh: Mesh | null;
}

/**
 * Runs the active step with other values of one parameter beside the editor's own run: one after the other, the newest settings of
 * the one that has waited longest. While a gesture goes on they follow it from where they are; then each is run from rest.
 */
export class Comparison {
  readonly #parts: ComparisonParts;
  #parameter: string | null = null;
  #places: Place[] = [];
  #isWorking = false;
  /** Those that ran, the latest last. */
  #turn: Place[] = [];
  #running: { readonly of: StepInputs; readonly off: AbortController; hasShown: boolean } | null = null;
  readonly #unlisten: () => void;

  constructor(parts: ComparisonParts) {
    this.#parts = parts;
    this.#unlisten = parts.store.subscribe(() => this.#follow());
  }

  get pictures(): readonly Picture[] {
    return this.#places;
  }

  /** Compares these values of a parameter from now on; none ends it. */
  compare(parameter: string, values: readonly string[]): void {
    const known = this.#parameter === parameter ? this.#places : [];
    this.#parameter = parameter;
    this.#places = values.map((value) => known.find((one) => one.value === value) ?? this.#place(value));
    for (const place of known) if (!this.#places.includes(place)) this.#release(place);
    this.redraw();
    this.#follow();
  }

  /** Draws what there is, as it was when nothing moved. */
  redraw(): void {
    this.#places.forEach((place, k) => {
      if (place.result) void this.#parts.draw(k, place.result.positions);
    });
  }

  dispose(): void {
    this.#unlisten();
    this.#running?.off.abort();
    for (const place of this.#places.splice(0)) this.#release(place);
  }

  /** A new one; with the step's own result where that is of this value. */
  #place(value: string): Place {
    const place: Place = {
      value,
      result: null,
      isRunning: false,
      failure: null,
      failedAt: null,
      mesh: null,
    };
    const { project } = this.#parts.store.state;
    const own = project && activeStep(project).result;
    if (own && this.#isOf(place, project, own.of)) place.result = own;
    return place;
  }

  #follow(): void {
    const { project } = this.#parts.store.state;
    const running = this.#running;
    if (running && project && !this.#places.some((place) => this.#isOf(place, project, running.of))) {
      // What is being prepared serves the next run as well, and something has to be seen of a long drag.
      if (running.hasShown || !this.#parts.isFollowing()) running.off.abort();
    }
    if (!this.#isWorking) void this.#work();
  }

  async #work(): Promise<void> {
    this.#isWorking = true;
    // The editor has told of a change and is about to begin with it.
    await null;
    for (let next = this.#next(); next; next = this.#next()) {
      // The one that has waited longest comes first.
      this.#turn = [...this.#turn.filter((one) => one !== next!.place), next.place];
      await this.#run(next.place, next.of, next.project);
    }
    this.#isWorking = false;
  }

  #next(): { place: Place; of: StepInputs; project: Project } | null {
    const { project, activity } = this.#parts.store.state;
    const isFollowing = this.#parts.isFollowing();
    // The editor's own run comes first.
    if (!project || (!isFollowing && activity.kind !== 'idle')) return null;
    const waiting = this.#places.flatMap((place) => {
      const of = this.#inputs(place, project);
      if (!of || (place.failedAt && sameInputs(place.failedAt, of))) return [];
      const isThere = place.result !== null && sameInputs(place.result.of, of);
      return isThere && (isFollowing || place.result?.state !== 'preview') ? [] : [{ place, of, project }];
    });
    const turn = ({ place }: { place: Place }) => this.#turn.indexOf(place);
    return waiting.sort((a, b) => turn(a) - turn(b))[0] ?? null;
  }

  #inputs({ value }: Place, project: Project): StepInputs | null {
    const step = activeStep(project);
    const from = restShapeOf(project, step.id);
    if (!from || this.#parameter === null) return null;
    const parameters: ParameterValues = { ...step.parameters, [this.#parameter]: value };
    return inputsOf({ method: step.method, parameters }, from, project.assets);
  }

  #isOf(place: Place, project: Project, of: StepInputs): boolean {
    const now = this.#inputs(place, project);
    return now !== null && sameInputs(now, of);
  }

  async #run(place: Place, of: StepInputs, project: Project): Promise<void> {
    const { engine, resolver } = this.#parts;
    const isFollowing = this.#parts.isFollowing();
    const off = new AbortController();
    const running = { of, off, hasShown: false };
    this.#running = running;
    Object.assign(place, { isRunning: true, failure: null, failedAt: null });
    this.#parts.changed();
    try {
      const mesh = this.#meshOf(place, project, of);
      const { normalMap } = project.source;
      const run = await patiently({ signal: off.signal, current: () => !off.signal.aborted }, () =>
        runStep(engine, resolver, { mesh, normalMap }, of, {
          start: isFollowing ? 'current' : 'rest',
          positions: true,
          fields: !isFollowing,
          signal: off.signal,
          onProgress: (progress) => {
            if (progress.kind !== 'iterating' || !progress.positions) return undefined;
            running.hasShown = true;
            return this.#draw(place, progress.positions);
          },
        }),
      );
      const isSettled = !isFollowing && !off.signal.aborted;
      place.result = resultOf(run, isSettled ? 'settled' : 'preview', of);
      void this.#draw(place, run.positions);
    } catch (thrown) {
      if (!off.signal.aborted) {
        place.failure = toFailure(thrown).message;
        place.failedAt = of;
      }
    }
    place.isRunning = false;
    this.#running = null;
    if (!this.#places.includes(place)) this.#release(place);
    this.#parts.changed();
  }

  #meshOf(place: Place, project: Project, { from }: StepInputs): Mesh {
    if (place.mesh?.positions !== from) {
      this.#release(place);
      place.mesh = movedMesh(project.mesh, from);
    }
    return place.mesh!;
  }

  #draw(place: Place, positions: Float64Array): Promise<void> {
    const at = this.#places.indexOf(place);
    return at < 0 ? Promise.resolve() : this.#parts.draw(at, positions);
  }

  #release(place: Place): void {
    if (place.mesh && !place.isRunning) {
      this.#parts.engine.release(place.mesh);
      place.mesh = null;
    }
  }
}
