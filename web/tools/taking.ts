import type { HandleGroup } from '../../src/editor/handle-groups.ts';
import { activeStep, type Project } from '../../src/editor/project.ts';
import { diagonalOf } from '../../src/mesh/extent.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { gripsSides } from '../../src/methods/set-by-hand.ts';
import {
  type Candidate,
  candidateAt,
  discAround,
  oppositeSide,
  type SelectableMesh,
} from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Hit } from '../../src/viewer/picking/picking.ts';

import type { HandleActions } from '../app/handle-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Selectable } from '../app/selectable.ts';
import { aimAt, reachOf } from './aim.ts';
import { ScreenMap } from './screen-map.ts';

/** What a press takes: the side, edge or rim that a person means who points there, or what is under a brush. */
export type TakeWay = 'side' | 'spot';

export interface TakingParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly handles: HandleActions;
  readonly surface: Selectable;
}

/** What is under the pointer. */
export interface Under {
  readonly hit: Hit;
  /** Of the file. */
  readonly positions: readonly number[];
  /** The side, edge or rim that these are; null for what is under a brush. */
  readonly candidate: Candidate | null;
}

/** Finds what a tool takes of the mesh where a pointer is. */
export class Taking {
  readonly #parts: TakingParts;
  /** Radius of the brush, as a share of the mesh's diagonal. */
  size = 0.07;
  /** What a person wants to take; null for what suits the method. */
  wanted: TakeWay | null = null;

  constructor(parts: TakingParts) {
    this.#parts = parts;
  }

  get way(): TakeWay {
    const { project } = this.#parts.store.state;
    if (this.wanted || !project) return this.wanted ?? 'spot';
    return gripsSides(findMethod(activeStep(project).method)) ? 'side' : 'spot';
  }

  /** Null beside the mesh. */
  at(pointer: CanvasPointer): Under | null {
    const { store, interaction, surface } = this.#parts;
    const hit = interaction.picking.pick(pointer);
    const { project } = store.state;
    if (!hit || !project) return null;
    const selectable = surface.of(project);
    // One vertex alone until the mesh has been looked at.
    if (!selectable) return { hit, positions: [nearest(hit)], candidate: null };
    const spot = this.size * diagonalOf(project.mesh);
    if (this.way === 'spot') {
      const positions = inFile(project, discAround(selectable, hit, spot));
      return { hit, positions, candidate: null };
    }
    const map = new ScreenMap(interaction.viewer, weldOf(project.mesh).positionOfVertex);
    const aim = aimAt(hit, pointer, map, lineShare * reachOf[pointer.kind]);
    const candidate = candidateAt(selectable, aim, { oneVertex: pointer.alt, flatSide: true, spot });
    return { hit, positions: inFile(project, candidate.vertices), candidate };
  }

  /** The group of handles there. */
  groupAt({ hit }: Under): HandleGroup | undefined {
    return this.#parts.handles.groupAt(nearest(hit));
  }

  /** What has to stay for a side to be pulled away from it; undefined where nothing lies opposite. */
  opposite({ candidate }: Under): readonly number[] | undefined {
    const { project } = this.#parts.store.state;
    const selectable: SelectableMesh | null = project && this.#parts.surface.of(project);
    const found = candidate && selectable && oppositeSide(selectable, candidate.faces);
    return found && project ? inFile(project, found) : undefined;
  }
}

/** Sides are what is pulled mostly: a line is only meant where the pointer is on it. */
const lineShare = 0.5;

function nearest({ corners, weights }: Hit): number {
  return corners[weights.indexOf(Math.max(...weights))]!;
}

function inFile({ mesh }: Project, vertices: Uint32Array): number[] {
  const { positionOfVertex } = weldOf(mesh);
  return Array.from(vertices, (vertex) => positionOfVertex[vertex]!);
}
