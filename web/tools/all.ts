import type { Interaction } from '../../src/viewer/interaction.ts';
import type { CubeActions } from '../app/cube-actions.ts';
import type { HandleActions } from '../app/handle-actions.ts';
import type { LineActions } from '../app/line-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import type { PlaneActions } from '../app/plane-actions.ts';
import type { Selectable } from '../app/selectable.ts';
import type { Selecting } from '../app/selecting.ts';
import type { StrengthActions } from '../app/strength-actions.ts';
import { MarkLines } from './mark-lines.ts';
import { MoveHandles } from './move-handles.ts';
import { PaintStrength } from './paint-strength.ts';
import { SelectTool } from './select.ts';
import { TurnCube } from './turn-cube.ts';

/** What tools work with. */
export interface ToolParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly handles: HandleActions;
  readonly cube: CubeActions;
  readonly strength: StrengthActions;
  readonly planes: PlaneActions;
  readonly lines: LineActions;
  readonly surface: Selectable;
  readonly selecting: Selecting;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

/** Every tool; a new one is a file beside this, its line here, its options among the panels and its face on the strip. */
export function makeTools(parts: ToolParts) {
  return {
    select: new SelectTool(parts),
    move: new MoveHandles(parts),
    lines: new MarkLines(parts),
    paint: new PaintStrength(parts),
    cube: new TurnCube(parts),
  };
}

export type Tools = ReturnType<typeof makeTools>;
