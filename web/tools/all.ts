import type { Editor } from '../../src/editor/editor.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Tool, ToolId } from './tool.ts';

/** What a tool works with. */
export interface ToolParts {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly interaction: Interaction;
}

/** Every tool; a new one is a file beside this, its line here, its options among the panels and its face on the strip. */
export function makeTools(_parts: ToolParts): ReadonlyMap<ToolId, Tool> {
  return new Map();
}
