import { expect, test } from 'vitest';
import type { MeshReport } from '../../src/mesh/mesh.ts';
import { oddities } from '../../src/mesh/report-sentences.ts';
import { plainReport } from '../fixtures/fake-engine.ts';

const sound: MeshReport = {
  ...plainReport(8, 12),
  components: 2,
  typicalPart: 4,
  boundaryEdges: 4,
};

test('holes and several parts are no cause for a warning', () => {
  expect(oddities(sound)).toEqual([]);
});

test.each([
  [{ isolatedVertices: 1 }, '1 vertex belongs to no face'],
  [{ isolatedVertices: 3 }, '3 vertices belong to no face'],
  [{ farVertices: 3 }, '3 vertices lie very far from the rest'],
  [{ nearPlaces: 1 }, '1 place differs from another only by rounding'],
  [{ nearPlaces: 7 }, '7 places differ from others only by rounding'],
  [{ degenerateFaces: 2 }, '2 faces have no area'],
  [{ duplicateFaces: 1 }, '1 face repeats another'],
  [{ duplicateFaces: 4 }, '4 faces repeat others'],
  [{ turnedFaces: 9 }, '9 faces looked the other way'],
  [{ oneSidedEdges: 2 }, '2 edges join faces that cannot look the same way'],
  [{ nonManifoldEdges: 5 }, '5 edges join three faces or more'],
])('%o is told in one sentence', (odd, beginning) => {
  const [sentence, ...others] = oddities({ ...sound, ...odd });
  expect(sentence).toMatch(new RegExp(`^${beginning}.*\\.$`));
  expect(others).toEqual([]);
});
