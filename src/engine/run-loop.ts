import { oddities } from '../mesh/report-sentences.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import type { EncodedValues } from './encode.ts';
import type { FrameGate } from './frames.ts';
import type { Hop } from './hop.ts';
import type { LoadedMesh } from './loaded-mesh.ts';
import type { Outcome, Solved, SolveSettings } from './protocol.ts';

/** Messages get in at least this often, single steps permitting. Shorter would slow small meshes. */
const hopMilliseconds = 8;

/** One solve while it waits or runs. */
export class Run {
  readonly settings: SolveSettings;
  readonly frames: FrameGate;
  /** Settles (never rejects) when nothing of this run will touch the mesh any more. */
  readonly ended: Promise<void>;
  readonly end: () => void;
  #isCancelled = false;
  #isSuperseded = false;

  constructor(settings: SolveSettings, frames: FrameGate) {
    this.settings = settings;
    this.frames = frames;
    let end = () => {};
    this.ended = new Promise((resolve) => {
      end = resolve;
    });
    this.end = end;
  }

  /** Somebody wants it to end, now. */
  get isCancelled(): boolean {
    return this.#isCancelled;
  }

  /** A newer run of the same mesh waits. */
  get isSuperseded(): boolean {
    return this.#isSuperseded;
  }

  cancel(): void {
    this.#isCancelled = true;
  }

  supersede(): void {
    this.#isSuperseded = true;
  }
}

/**
 * Steps until the core says that it is done or somebody stops the run, and answers with what there is. The core steps, this
 * loops: between steps, messages get in and frames get out.
 *
 * @param values the run's parameters as the core takes them
 */
export async function runToEnd(mesh: LoadedMesh, values: EncodedValues, run: Run, hop: Hop): Promise<Solved> {
  const { method, parameters, start } = run.settings;
  const began = performance.now();
  // A cancel or a newer request may already wait; preparing can take long.
  await hop();
  const isSkipped = run.isCancelled || run.isSuperseded;
  // The newer run may start from 'current' and means what this one would have made of it.
  if (run.isSuperseded && start === 'rest') mesh.restart();
  if (!isSkipped) mesh.prepare(method, values, start === 'rest');
  const prepared = performance.now();

  const energy: number[] = [];
  const outcome = isSkipped ? 'cancelled' : await iterate(mesh, parameters, run, hop, energy);
  const positions = mesh.copyPositions();
  const milliseconds = { prepare: prepared - began, solve: performance.now() - prepared };
  return {
    outcome,
    iterations: energy.length,
    energy,
    positions,
    milliseconds,
    warnings: oddities(mesh.report),
  };
}

async function iterate(
  mesh: LoadedMesh,
  { maxIterations }: ParameterValues,
  run: Run,
  hop: Hop,
  energy: number[],
): Promise<Outcome> {
  // The core would answer with a step that is no iteration.
  if (maxIterations === 0) return 'iteration-limit';
  let lastHop = Number.NEGATIVE_INFINITY;
  for (;;) {
    const now = performance.now();
    if (now - lastHop >= hopMilliseconds) {
      await hop();
      lastHop = performance.now();
    }
    // What is prepared makes one step even if it is overtaken: else a fast drag on a large mesh would show nothing.
    if (run.isCancelled || (run.isSuperseded && energy.length > 0)) return 'cancelled';
    const step = mesh.step();
    energy.push(step.energy);
    if (step.outcome !== 'running') return step.outcome;
    run.frames.add(energy.length, step, performance.now());
  }
}
