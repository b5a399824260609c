import { oddities } from '../mesh/report-sentences.ts';
import type { EncodedValues } from './encode.ts';
import type { Hop } from './hop.ts';
import type { LoadedMesh } from './loaded-mesh.ts';
import type { ProgressGate } from './progress-gate.ts';
import type { Outcome, Solved, SolveSettings } from './protocol.ts';

/** Messages get in at least this often, single steps permitting. Shorter would slow small meshes. */
const hopMilliseconds = 8;

/** A run that is overtaken still makes so many steps, or goes on for so long: a drag shows shapes that are on their way, not first guesses. */
const leastSteps = 4;
const leastMilliseconds = 90;

/** One solve while it waits or runs. */
export class Run {
  readonly settings: SolveSettings;
  readonly progress: ProgressGate;
  /** Settles (never rejects) when nothing of this run will touch the mesh any more. */
  readonly ended: Promise<void>;
  readonly end: () => void;
  #isCancelled = false;
  #isSuperseded = false;

  constructor(settings: SolveSettings, progress: ProgressGate) {
    this.settings = settings;
    this.progress = progress;
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
 * loops: between steps, and between stages of preparing, messages get in and progress gets out.
 *
 * @param values the run's parameters as the core takes them
 */
export async function runToEnd(mesh: LoadedMesh, values: EncodedValues, run: Run, hop: Hop): Promise<Solved> {
  const { start } = run.settings;
  const began = performance.now();
  // A cancel or a newer request may already wait.
  await hop();
  const isSkipped = run.isCancelled || run.isSuperseded;
  // The newer run may start from 'current' and means what this one would have made of it.
  if (run.isSuperseded && start === 'rest') mesh.restart();
  const isPrepared = !isSkipped && (await prepare(mesh, values, run, hop));
  const prepared = performance.now();

  const energy: number[] = [];
  const outcome = isPrepared ? await iterate(mesh, run, hop, energy) : 'cancelled';
  const positions = mesh.copyPositions();
  return {
    outcome,
    iterations: energy.length,
    energy,
    positions,
    milliseconds: { prepare: prepared - began, solve: performance.now() - prepared },
    warnings: [...oddities(mesh.report), ...(isPrepared ? mesh.warnings() : [])],
    fields: isPrepared ? mesh.fields() : [],
  };
}

/**
 * Prepares stage by stage. What was done stays: the run that overtakes this one goes on from there.
 *
 * @returns false if the run was cancelled or overtaken meanwhile
 */
async function prepare(mesh: LoadedMesh, values: EncodedValues, run: Run, hop: Hop): Promise<boolean> {
  mesh.configure(run.settings.method, values, run.settings.start === 'rest');
  for (let lastHop = performance.now(); ; ) {
    const { stage, share } = mesh.prepareNext();
    if (share >= 1) return true;
    if (performance.now() - lastHop < hopMilliseconds) continue;
    run.progress.prepare({ stage, share }, performance.now());
    await hop();
    lastHop = performance.now();
    if (run.isCancelled) return false;
    // One of two that come one after the other must get to its first step: else a fast drag on a large mesh would show nothing.
    if (run.isSuperseded && !mesh.isOverdue) {
      mesh.isOverdue = true;
      return false;
    }
  }
}

async function iterate(mesh: LoadedMesh, run: Run, hop: Hop, energy: number[]): Promise<Outcome> {
  // The core would answer with a step that is no iteration.
  if (run.settings.parameters.maxIterations === 0) return 'iteration-limit';
  const began = performance.now();
  let lastHop = Number.NEGATIVE_INFINITY;
  for (;;) {
    const now = performance.now();
    if (now - lastHop >= hopMilliseconds) {
      await hop();
      lastHop = performance.now();
    }
    // What is prepared makes one step at least even if it is overtaken: else a fast drag on a large mesh would show nothing.
    const isWell = energy.length >= leastSteps || (energy.length > 0 && now - began >= leastMilliseconds);
    if (run.isCancelled || (run.isSuperseded && isWell)) return 'cancelled';
    const step = mesh.step();
    if (step.outcome === 'midway') continue;
    mesh.isOverdue = false;
    energy.push(step.energy);
    if (step.outcome !== 'running') return step.outcome;
    run.progress.add(energy.length, step, performance.now());
  }
}
