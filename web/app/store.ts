import { emptyHistory, type History } from '../../src/editor/history.ts';
import type { WhittleDocument } from '../../src/editor/project.ts';
import type { Overlay, OverlayName } from '../../src/measures/index.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Shading } from '../../src/viewer/viewer.ts';
import { builtInPictures, type Picture } from './image-gallery.ts';
import { builtIn, type StyleEntry } from './style-gallery.ts';

export type Activity =
  | { readonly kind: 'idle' }
  | { readonly kind: 'opening'; readonly name: string }
  | { readonly kind: 'writing'; readonly name: string }
  | {
      readonly kind: 'solving';
      /** Following a gesture, or settling what it left. */
      readonly live: boolean;
      readonly iteration: number;
      readonly energy: readonly number[];
    };

export const idle: Activity = Object.freeze({ kind: 'idle' });

/** Something to tell a person. It stays until it is dismissed or replaced. */
export interface Notice {
  readonly tone: 'error' | 'note';
  readonly text: string;
  readonly action?: { readonly label: string; readonly run: () => void };
}

export type Theme = 'auto' | 'light' | 'dark';

/** How one looks at the document; never undone. */
export interface Look {
  readonly shading: Shading;
  readonly theme: Theme;
  /** The file's own shape is shown in place of the result. */
  readonly comparing: boolean;
  readonly overlay: OverlayName;
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
  /** The painter is open. */
  readonly painting: boolean;
}

export interface State {
  readonly document: WhittleDocument | null;
  readonly history: History;
  readonly activity: Activity;
  readonly notice: Notice | null;
  readonly look: Look;
  /** What {@link Look.overlay} measures of the document. */
  readonly overlay: Overlay | null;
  readonly gallery: Gallery;
  /** What there is to lay on the mesh; never undone. */
  readonly pictures: readonly Picture[];
}

export type Listener = (state: State) => void;

/** The page's one state and those who look at it. */
export class Store {
  #state: State = {
    document: null,
    history: emptyHistory,
    activity: idle,
    notice: null,
    look: { shading: 'smooth', theme: 'auto', comparing: false, overlay: 'none' },
    overlay: null,
    gallery: { entries: builtIn, pending: null, flow: null, offer: null, painting: false },
    pictures: builtInPictures,
  };
  readonly #listeners = new Set<Listener>();

  get state(): State {
    return this.#state;
  }

  set(change: Partial<State>): void {
    this.#state = { ...this.#state, ...change };
    for (const listener of this.#listeners) listener(this.#state);
  }

  /** Calls the listener on every change from now on, until the returned function is called. */
  subscribe(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
