export { fileOfAsset, filesNamedBy, type NamedFile, readAsset, withFileNames } from './assets.ts';
export { checkGroups, type Group, parseGroups } from './groups.ts';
export { linkText, recipeOfLink } from './link.ts';
export { formatRecipe, parseRecipe, type Recipe, type RecipeStep, withPlainArrays } from './recipe.ts';
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
