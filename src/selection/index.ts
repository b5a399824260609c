export { type Candidate, type CandidateOptions, candidateAt, partOf } from './candidate.ts';
export { discAround, placeOf, type SurfacePoint } from './disc.ts';
export { type DrawnSelection, drawnOf } from './drawn.ts';
export { facesInside } from './face-sets.ts';
export { defaultFeatureAngle, sharpEdges } from './features.ts';
export { type FittedPlane, fittedPlane, reachOf } from './fitted-plane.ts';
export { type Line, lineAt } from './lines.ts';
export { alone, aloneIn, type MirrorMap, type MirrorPlane, mirrored, mirrorMap } from './mirror.ts';
export type { Aim, ScreenPoint } from './near-pointer.ts';
export { oppositeSide } from './opposite-side.ts';
export { boxRegion, type ScreenRegion, verticesInside } from './screen-region.ts';
export { type SelectableMesh, type SelectableOptions, selectableOf } from './selectable.ts';
export {
  type Combination,
  combined,
  everything,
  grown,
  inverted,
  nothing,
  piecesOf,
  type Selection,
  selectedVertices,
  shrunk,
} from './selection.ts';
export { otherEnd } from './topology.ts';
export { type ScreenShape, Visibility } from './visibility.ts';
export { atOnce, inSlices, type SliceOptions, type Work } from './work.ts';
