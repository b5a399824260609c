import type { Figure } from './figure.ts';
import { heldFigures } from './held.ts';
import { polyhedronFigures } from './polyhedra.ts';
import { posedFigures } from './posed.ts';
import { reshapedFigures } from './reshaped.ts';
import { strengthFigures } from './strength.ts';

/** In the order of the papers. */
export const figures: readonly Figure[] = [
  ...heldFigures,
  ...strengthFigures,
  ...polyhedronFigures,
  ...posedFigures,
  ...reshapedFigures,
];
