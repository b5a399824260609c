import type { MeshReport } from '../mesh/mesh.ts';
import type { GaussMap } from './values/gauss-map.ts';

/** A mesh of this many vertices looks right at {@link usualLambda}. */
const usualVertices = 7500;
const usualLambda = 0.45;

/**
 * The λ that a mesh opens with: clearly cubic, details still there. Finer meshes need less for the same look, because ARAP
 * resists bending less as cells shrink. Fitted by eye with the page's own samples: 0.9 for the rabbit (2.8 k vertices), 0.45
 * for Suzanne (7.5 k), 0.3 for the vase (14 k).
 *
 * @param vertices of a typical part: parts are bent each on its own
 */
export function startingLambda(vertices: number): number {
  const lambda = usualLambda * (usualVertices / Math.max(1, vertices)) ** 0.7;
  return Number(Math.min(1.2, Math.max(0.03, lambda)).toPrecision(2));
}

/**
 * The λ that a style is first put on with, by eye on the page's own samples: four where normals snap to few faces, so that
 * edges show; less where they vary smoothly, or it crumples. The mesh's fineness matters little at this strength.
 */
export function startingStrength(map: GaussMap): number {
  return map.kind === 'closest' ? 4 : 2.5;
}

/** Below this many vertices a part has too few to bend round an edge: ARAP's resistance to it blurs a faceted style away. */
const coarse = 1000;

/** What details keep at first: where a coarse mesh meets flat faces, the triangles their shape; elsewhere ARAP, the smoothest. */
export function startingRegularizer(
  { typicalPart }: Pick<MeshReport, 'typicalPart'>,
  map: GaussMap,
): 'arap' | 'farap' {
  return map.kind === 'closest' && typicalPart < coarse ? 'farap' : 'arap';
}
