/** Vertices of a mesh on which {@link usualLambda} gives the look that the page wants to open with. */
const usualVertices = 7000;
const usualLambda = 0.2;

/**
 * The λ that a mesh opens with: clearly cubic, details still there. The ℓ1 term weighs areas against the smoothness of
 * ARAP's cells, so the same look needs less on finer meshes. The exponent is to be measured.
 *
 * @param vertices count of the welded mesh
 */
export function startingLambda(vertices: number): number {
  const lambda = usualLambda * Math.sqrt(usualVertices / Math.max(1, vertices));
  return Number(Math.min(0.6, Math.max(0.05, lambda)).toPrecision(2));
}
