import type { MeshReport } from '../mesh/mesh.ts';
import type { GaussMap } from './values/gauss-map.ts';
import type { ParameterDescriptor, ParameterValues } from './values/index.ts';

/** The normals that a method draws the mesh's to. */
export interface StyleTargets {
  /** The parameter whose value, or name, tells the style. */
  readonly style: string;
  /** Whose normals the targets are looked up from: the input's once, or the output's as it goes. */
  readonly lookedUpFrom: 'input' | 'output';
}

/** What values to start from depend on. */
export interface StartingPoint {
  readonly report: MeshReport;
  /** The style that the method is to take, if it takes one and one was chosen. */
  readonly style: GaussMap | null;
}

/** What a person wants of a mesh, in the order in which the page offers it. */
export const intents = [
  { id: 'carve', title: 'Carve' },
  { id: 'fold', title: 'Fold' },
  { id: 'move', title: 'Move' },
] as const;

export type Intent = (typeof intents)[number]['id'];

/** A method as page, recipe, command line and element see it. */
export interface MethodDescriptor {
  readonly id: string;
  readonly title: string;
  /** What a person wants who takes it; absent where only other methods need it. */
  readonly intent?: Intent;
  /** One sentence for the panel and `whittle methods`. */
  readonly summary: string;
  readonly paper: string;
  /** How its results are looked at best: boxes and folded sheets by their faces. */
  readonly shading: 'smooth' | 'flat';
  /** What normals are drawn to, for these values; absent where the method has no targets that a style tells. */
  readonly targets?: (values: ParameterValues) => StyleTargets;
  /** Values that suit a mesh and a style better than the defaults. */
  readonly startingValues?: (about: StartingPoint) => ParameterValues;
  readonly parameters: readonly ParameterDescriptor[];
}
