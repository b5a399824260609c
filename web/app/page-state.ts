import { type EditorState, emptyState, Store } from '../../src/editor/state.ts';
import type { LineField, Overlay, OverlayName } from '../../src/measures/index.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Box } from '../../src/viewer/box.ts';
import type { Shading } from '../../src/viewer/viewer.ts';
import type { ToolId } from '../tools/tool.ts';
import { builtInImages, type ImageEntry } from './image-gallery.ts';
import { type SelectState, startingSelect } from './select-state.ts';
import { builtIn, type StyleEntry } from './style-gallery.ts';

export type Theme = 'auto' | 'light' | 'dark';

/** How one looks at the project; never undone. */
export interface Look {
  readonly shading: Shading;
  readonly theme: Theme;
  /** The file's own shape is shown in place of the result. */
  readonly comparing: boolean;
  readonly overlay: OverlayName;
  /** The names of the lines that are drawn over the mesh. */
  readonly lines: readonly string[];
}

/** A style mesh on its way to the sphere. */
export interface Flow {
  readonly name: string;
  readonly mesh: Pick<Mesh, 'positions' | 'triangles'>;
  /** #P×3; good until the next frame. */
  readonly positions: Float64Array;
}

/** A dropped style that is not convex, and waits for a word whether to read it through the sphere. */
export interface Offer {
  readonly entry: StyleEntry;
  readonly why: string;
}

/** What there is to borrow from; never undone. */
export interface Gallery {
  readonly entries: readonly StyleEntry[];
  /** The style that is being read, by its id. */
  readonly pending: string | null;
  readonly flow: Flow | null;
  readonly offer: Offer | null;
  /** The normal painter is open. */
  readonly painting: boolean;
}

/** The editor's state and what only a page has. */
export interface PageState extends EditorState {
  readonly look: Look;
  /** What is in the hand; never undone. */
  readonly tool: ToolId;
  readonly select: SelectState;
  /** What {@link Look.overlay} measures of the project. */
  readonly overlay: Overlay | null;
  /** The values that are looked at beside the active step's own; none while one looks at that alone. Never undone. */
  readonly compared: readonly string[];
  /** Where each picture is on the canvas, the step's own first. */
  readonly frames: readonly Box[];
  readonly gallery: Gallery;
  /** What {@link Look.lines} draw of the project. */
  readonly lines: readonly LineField[];
  /** What there is to lay on the mesh; never undone. */
  readonly images: readonly ImageEntry[];
}

export type PageStore = Store<PageState>;

export function newPageStore(): PageStore {
  return new Store<PageState>({
    ...emptyState,
    look: { shading: 'smooth', theme: 'auto', comparing: false, overlay: 'none', lines: [] },
    tool: 'turn',
    select: startingSelect,
    overlay: null,
    lines: [],
    compared: [],
    frames: [],
    gallery: { entries: builtIn, pending: null, flow: null, offer: null, painting: false },
    images: builtInImages,
  });
}
