import type { MeshReport } from '../mesh/mesh.ts';

/** Sentences about what is odd in a mesh and what the solver does with it. Holes and several parts are not odd. */
export function warningsOf(report: MeshReport): string[] {
  const { isolatedVertices, degenerateFaces, duplicateFaces, nonManifoldEdges } = report;
  const warnings: string[] = [];
  const warn = (count: number, one: string, many: string): void => {
    if (count > 0) warnings.push(count === 1 ? `1 ${one}` : `${count} ${many}`);
  };
  warn(
    isolatedVertices,
    'vertex belongs to no face and stays where it is.',
    'vertices belong to no face and stay where they are.',
  );
  warn(
    degenerateFaces,
    'face has no area; it is kept, with its stiffness limited.',
    'faces have no area; they are kept, with their stiffness limited.',
  );
  warn(
    duplicateFaces,
    'face repeats another; that place counts twice.',
    'faces repeat others; those places count twice.',
  );
  warn(
    nonManifoldEdges,
    'edge joins three faces or more; they bend together.',
    'edges join three faces or more; those faces bend together.',
  );
  return warnings;
}
