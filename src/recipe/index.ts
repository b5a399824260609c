export { isObject, parseJson } from './json.ts';
export { formatRecipe, parseRecipe, type Recipe, type RecipeStep } from './recipe.ts';
