import type { Outcome } from '../engine/protocol.ts';
import type { MeshReport } from '../mesh/mesh.ts';
import type { StepRun } from '../recipe/index.ts';

type InputReport = Pick<
  MeshReport,
  'vertices' | 'faces' | 'components' | 'boundaryEdges' | 'nonManifoldEdges' | 'degenerateFaces'
>;

export interface StepReport {
  readonly method: string;
  readonly iterations: number;
  readonly outcome: Outcome;
  /** Per iteration, in the unit frame. */
  readonly energy: readonly number[];
  /** `read` counts for the first step and `write` for the last; both are 0 otherwise. */
  readonly milliseconds: { read: number; prepare: number; solve: number; write: number };
  readonly warnings: string[];
}

/** What `--report` writes. */
export interface RunReport {
  /** Counts of the mesh after welding. */
  readonly input: InputReport;
  readonly steps: readonly StepReport[];
}

export function inputReport(report: MeshReport): InputReport {
  const { vertices, faces, components, boundaryEdges, nonManifoldEdges, degenerateFaces } = report;
  return { vertices, faces, components, boundaryEdges, nonManifoldEdges, degenerateFaces };
}

export function stepReport({
  method,
  iterations,
  outcome,
  energy,
  milliseconds,
  warnings,
}: StepRun): StepReport {
  const { prepare, solve } = milliseconds;
  return {
    ...{ method, iterations, outcome, energy, warnings: [...warnings] },
    milliseconds: { read: 0, prepare, solve, write: 0 },
  };
}
