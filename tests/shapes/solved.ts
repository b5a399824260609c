import type { WhittleError } from '../../src/mesh/failure.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { configure, prepare, testCore } from '../fixtures/core.ts';
import type { TestMesh } from '../fixtures/subdivision.ts';

/** A run of `reshape` on the real core, to its end. */
export interface Reshaped {
  /** #V×3 */
  readonly positions: Float64Array<ArrayBuffer>;
  readonly iterations: number;
  readonly outcome: string;
  readonly warnings: readonly string[];
  /** Milliseconds for all of it. */
  readonly time: number;
}

/** @param watch is given the positions after every iteration */
export async function reshaped(
  mesh: TestMesh,
  handles: Handles,
  values: ParameterValues = {},
  watch?: (positions: Float64Array) => void,
): Promise<Reshaped> {
  const session = (await testCore()).open();
  try {
    const began = performance.now();
    session.load(mesh.positions, mesh.triangles);
    configure(session, mesh, 'reshape', { handles, ...values });
    prepare(session);
    const positions = new Float64Array(mesh.positions.length);
    let iterations = 0;
    let outcome: string = 'running';
    while (outcome === 'running' || outcome === 'midway') {
      outcome = session.step().outcome;
      if (outcome === 'midway') continue;
      iterations++;
      if (!watch) continue;
      session.copyPositions(positions);
      watch(positions);
    }
    session.copyPositions(positions);
    return { positions, iterations, outcome, warnings: session.warnings(), time: performance.now() - began };
  } finally {
    session.free();
  }
}

/**
 * Runs that each start from where the one before came to, as in a drag.
 *
 * @param slices after which a run is overtaken; without, it goes on to its end
 * @returns positions at each place, #V×3
 */
export async function dragged(
  mesh: TestMesh,
  places: readonly Handles[],
  slices = Number.POSITIVE_INFINITY,
): Promise<Float64Array[]> {
  const session = (await testCore()).open();
  try {
    session.load(mesh.positions, mesh.triangles);
    return places.map((handles) => {
      configure(session, mesh, 'reshape', { handles });
      prepare(session);
      for (let slice = 0, isGoing = true; isGoing && slice < slices; slice++)
        isGoing = ['running', 'midway'].includes(session.step().outcome);
      const positions = new Float64Array(mesh.positions.length);
      session.copyPositions(positions);
      return positions;
    });
  } finally {
    session.free();
  }
}

/** How a run was refused; undefined if it was not. */
export async function refusal(
  mesh: TestMesh,
  handles: Handles,
  values: ParameterValues = {},
): Promise<WhittleError | undefined> {
  return reshaped(mesh, handles, values).then(
    () => undefined,
    (error: WhittleError) => error,
  );
}
