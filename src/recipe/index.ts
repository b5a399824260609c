export { checkGroups, type Group } from './groups.ts';
export { formatRecipe, parseRecipe, type Recipe, type RecipeStep } from './recipe.ts';
export {
  type Asset,
  type FlowListener,
  Resolver,
  type Surroundings,
  type TexturedMesh,
} from './resolve.ts';
export {
  type RecipeRun,
  type RunOptions,
  runRecipe,
  runStep,
  type StepOptions,
  type StepRun,
} from './run.ts';
