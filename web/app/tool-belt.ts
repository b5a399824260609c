import { activeStep } from '../../src/editor/project.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { chainsParameters } from '../../src/methods/set-by-hand.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Tools } from '../tools/all.ts';
import type { Tool, ToolId } from '../tools/tool.ts';
import type { PageStore } from './page-state.ts';

/** How a tool is shown on the strip. */
export interface ToolFace {
  readonly id: ToolId;
  readonly title: string;
  /** As `KeyboardEvent.key`, lower case. */
  readonly key: string;
  /** One sentence for the help and the tooltip. */
  readonly does: string;
  /** Whether it can do anything for a method. Default: always, or it says why not. */
  readonly suits?: (method: MethodDescriptor | undefined) => boolean;
}

/** All tools, in the order of the strip. */
export const toolFaces: readonly ToolFace[] = [
  { id: 'turn', title: 'Turn', key: 'v', does: 'Turn and move the view.' },
  { id: 'select', title: 'Select', key: 'q', does: 'Choose a part of the mesh, to hold, move or name it.' },
  { id: 'move', title: 'Move', key: 'w', does: 'Hold parts still and pull others; the rest follows.' },
  {
    id: 'lines',
    title: 'Lines',
    key: 'l',
    does: 'Mark edges that are sharp, or smooth, or stay straight.',
    suits: (method) => chainsParameters(method).length > 0,
  },
  { id: 'paint', title: 'Paint', key: 'd', does: 'Paint where the style is strong and where it is not.' },
  { id: 'cube', title: 'Cube', key: 'c', does: 'Turn and stretch the cube that the mesh is drawn to.' },
];

/** The tools there are, of which one is in the hand. */
export class ToolBelt {
  readonly #store: PageStore;
  readonly #interaction: Interaction | null;
  /** Null where nothing is drawn. */
  readonly all: Tools | null;

  /** @param interaction null where nothing is drawn: then the view is all there is, and there are no tools */
  constructor(store: PageStore, interaction: Interaction | null, tools: Tools | null) {
    this.#store = store;
    this.#interaction = interaction;
    this.all = tools;
    // Another mesh takes all layers away, and what the tool was in the middle of is over.
    interaction?.viewer.onShape((change) => {
      if (change !== 'mesh') return;
      interaction.cancel();
      this.current?.leave();
      this.current?.enter();
      this.#tellReady();
    });
  }

  /** The tools that can be taken here. */
  get faces(): readonly ToolFace[] {
    const { project, tool } = this.#store.state;
    const method = project ? findMethod(activeStep(project).method) : undefined;
    return toolFaces.filter(
      ({ id, suits }) =>
        id === 'turn' || (this.#tool(id) !== null && (id === tool || !suits || suits(method))),
    );
  }

  get current(): Tool | null {
    return this.#tool(this.#store.state.tool);
  }

  choose(id: ToolId): void {
    if (id === this.#store.state.tool || !this.faces.some((face) => face.id === id)) return;
    this.#interaction?.setTool(null);
    this.current?.leave();
    this.#store.set({ tool: id });
    this.current?.enter();
    this.#interaction?.setTool(this.current);
    this.#tellReady();
  }

  /** A key for the tool in the hand, or one that takes another. @returns whether it was one */
  key(event: KeyboardEvent): boolean {
    if (event.key === 'Escape' && this.#interaction?.cancel()) return true;
    if (this.current?.key?.(event)) return true;
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const face = this.faces.find(({ key }) => key === event.key.toLowerCase());
    if (!face) return false;
    this.choose(face.id);
    return true;
  }

  /** The mesh is still being looked at, and the tool in the hand takes nothing yet. */
  get isBusy(): boolean {
    return this.current !== null && this.#interaction?.picking.isReady === false;
  }

  #tellReady(): void {
    if (this.current) void this.#interaction?.picking.ready().then(() => this.#store.set({}));
  }

  #tool(id: ToolId): Tool | null {
    return (this.all as Partial<Record<ToolId, Tool>> | null)?.[id] ?? null;
  }
}
