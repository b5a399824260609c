import type { Handles } from '../../src/methods/values/handles.ts';
import type { Hand } from './hand.ts';

/** What a figure came to, from what the page exports. */
export interface Outcome {
  /** #V×3, in the mesh’s own units. */
  readonly positions: Float64Array<ArrayBuffer>;
  /** What was held where in its last step; none where nothing was. */
  readonly handles: Handles;
}

/** A mesh that is not the one which the page opens with. */
export interface FigureMesh {
  /** A sample by its title in the menu, or the name of a file that is dropped. */
  readonly title: string;
  readonly path: string;
  /** Its own format, by its name in the export menu. */
  readonly format: string;
  /** What is in the file that is dropped; a sample lies at its path. */
  readonly bytes?: () => Uint8Array;
}

/** A picture of a figure of the papers. */
export interface Picture {
  readonly id: string;
  /** The year of its paper and its number there. */
  readonly of: string;
  readonly caption: string;
  /** What the paper’s figure shows. */
  readonly paper: string;
  /** In what this one is not that. */
  readonly differs?: string;
  readonly mesh?: FigureMesh;
  /** How one looks at it in the end: drags with the tool that turns the view. */
  readonly look?: (hand: Hand) => Promise<void>;
}

/** A figure of the papers, remade with the shapes that come with the page, in a window of 1200×800. */
export interface Figure extends Picture {
  readonly act: (hand: Hand) => Promise<void>;
  /** Expects of the outcome, of a mesh that is exported as OBJ, what the paper says of its figure. */
  readonly claims?: (outcome: Outcome) => void;
  /** The tool that is in hand on the picture, for what it draws; else that which turns the view. */
  readonly shows?: string;
}

export const suzanne: FigureMesh = {
  title: 'Suzanne',
  path: 'public/samples/suzanne.glb',
  format: 'glTF binary',
};
