import type { MeshReport } from './mesh.ts';

const count = new Intl.NumberFormat('en');

/** Sentences about what is odd in a mesh and what the solver does with it. Holes and several parts are not odd. */
export function oddities(report: MeshReport): string[] {
  const { isolatedVertices, degenerateFaces, duplicateFaces, nonManifoldEdges } = report;
  const { farVertices, nearPlaces, turnedFaces, oneSidedEdges } = report;
  const sentences: string[] = [];
  const say = (number: number, one: string, many: string): void => {
    if (number > 0) sentences.push(number === 1 ? `1 ${one}` : `${count.format(number)} ${many}`);
  };
  say(
    isolatedVertices,
    'vertex belongs to no face and stays where it is, unless it is a handle.',
    'vertices belong to no face and stay where they are, unless they are handles.',
  );
  say(
    farVertices,
    'vertex lies very far from the rest; it is shaped too, but the view looks at the rest.',
    'vertices lie very far from the rest; they are shaped too, but the view looks at the rest.',
  );
  say(
    nearPlaces,
    'place differs from another only by rounding; for the work they are one, your file keeps them apart.',
    'places differ from others only by rounding; for the work they are one, your file keeps them apart.',
  );
  say(
    degenerateFaces,
    'face has no area; your file keeps it, and it has next to no say in the work.',
    'faces have no area; your file keeps them, and they have next to no say in the work.',
  );
  say(
    duplicateFaces,
    'face repeats another; each place counts once.',
    'faces repeat others; each place counts once.',
  );
  say(
    turnedFaces,
    'face looked the other way than its neighbours and is turned for the work.',
    'faces looked the other way than their neighbours and are turned for the work.',
  );
  say(
    oneSidedEdges,
    'edge joins faces that cannot look the same way: the surface has only one side there.',
    'edges join faces that cannot look the same way: the surface has only one side there.',
  );
  say(
    nonManifoldEdges,
    'edge joins three faces or more; they bend together.',
    'edges join three faces or more; those faces bend together.',
  );
  return sentences;
}

/** The {@link oddities} and whatever else a person may wonder about; none for a plain closed mesh. */
export function remarks(report: MeshReport, hasUvs: boolean): string[] {
  const { components, boundaryEdges } = report;
  const sentences: string[] = [];
  if (components > 1)
    sentences.push(
      `It has ${count.format(components)} separate parts; those that touch stay together, others are shaped on their own.`,
    );
  if (boundaryEdges > 0)
    sentences.push(
      `${count.format(boundaryEdges)} boundary edges: the surface is open somewhere. That is fine.`,
    );
  sentences.push(...oddities(report));
  if (hasUvs) sentences.push('Its texture coordinates go home unchanged.');
  return sentences;
}
