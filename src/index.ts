// Whittle as a library. In Node the same names come from `index.node.ts`, whose engine needs no worker.

export type { CallOptions, Engine, ProgressListener, SolveOptions } from './engine/client.ts';
export type { CoreField, CoreOutcome } from './engine/core-api.ts';
export { type BrowserEngineOptions, createBrowserEngine as createEngine } from './engine/in-browser.ts';
export type {
  Iterating,
  Outcome,
  Preparing,
  Progress,
  ReadResult,
  Solved,
  SolveSettings,
  Start,
} from './engine/protocol.ts';
export type { Image } from './inputs/images/image.ts';
export {
  type EmbeddedImage,
  type Format,
  type FormatInfo,
  formatForFileName,
  formats,
  type ReadMesh,
  readMesh,
  writeMesh,
} from './io/index.ts';
export { type Failure, type FailureCode, failureCodes, WhittleError } from './mesh/failure.ts';
export type { Mesh, MeshReport, Weld } from './mesh/mesh.ts';
export type { MethodDescriptor, StartingPoint, StyleTargets } from './methods/descriptor.ts';
export { findMethod, methods } from './methods/registry.ts';
export type { GaussMap } from './methods/values/gauss-map.ts';
export type { Handles } from './methods/values/handles.ts';
export type { ParameterDescriptor, ParameterValue, ParameterValues } from './methods/values/index.ts';
export type { Plane, Planes } from './methods/values/planes.ts';
export type { SphereField } from './methods/values/sphere-field.ts';
export {
  type Asset,
  formatRecipe,
  type Group,
  parseRecipe,
  type Recipe,
  type RecipeRun,
  type RecipeStep,
  type RunOptions,
  runRecipe,
  type StepRun,
  type Surroundings,
  type TexturedMesh,
} from './recipe/index.ts';
