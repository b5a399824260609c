import type { Beginning } from '../editor/begin-project.ts';
import { imageParameter, styleParameter } from '../editor/starting-step.ts';
import { WhittleError } from '../mesh/failure.ts';
import { findMethod, methods } from '../methods/registry.ts';
import { didYouMean } from '../methods/suggest.ts';
import type { ParameterValue } from '../methods/values/index.ts';
import type { NumberParameter } from '../methods/values/number.ts';
import { parseRecipe } from '../recipe/index.ts';
import { fetchBytes, nameOf } from './fetch-bytes.ts';

/** What attributes say of the shape. */
export interface Wish {
  readonly method: string | null;
  readonly styleSrc: string | null;
  readonly recipe: string | null;
  readonly lambda: number | null;
}

/**
 * What an editor is to begin a mesh with; null where the mesh is to stay as it is.
 *
 * @param page what addresses are relative to
 * @throws WhittleError `unknown-method`, `bad-recipe`, or as the recipe cannot be fetched
 */
export async function beginningOf(
  { method: id, styleSrc, recipe, lambda }: Wish,
  page: string,
): Promise<Beginning | null> {
  if (recipe) return { recipe: await readRecipe(recipe, page) };
  if (!id) return null;
  const method = findMethod(id);
  if (!method) {
    const ids = methods.map((known) => known.id);
    throw new WhittleError('unknown-method', `There is no method “${id}”.${didYouMean(id, ids)}`);
  }
  const parameters: Record<string, ParameterValue> = {};
  const borrowed = styleParameter(method)?.name ?? imageParameter(method);
  if (styleSrc && borrowed) parameters[borrowed] = styleSrc;
  const strength = mainNumber(id);
  if (lambda !== null && strength) parameters[strength.name] = lambda;
  return { method: id, parameters };
}

/** The number that a person would change first: the method's strength. */
export function mainNumber(id: string | undefined): NumberParameter | undefined {
  return findMethod(id ?? '')?.parameters.find(
    (parameter): parameter is NumberParameter => 'slider' in parameter && !parameter.advanced,
  );
}

/** What the names of files are relative to: the recipe's own address, or else the page's. */
export function baseOf({ recipe }: Wish, page: string): string {
  return recipe && !isText(recipe) ? new URL(recipe, page).href : page;
}

function isText(recipe: string): boolean {
  return recipe.trimStart().startsWith('{');
}

async function readRecipe(given: string, page: string) {
  if (isText(given)) return parseRecipe(given, 'recipe');
  const text = new TextDecoder().decode(await fetchBytes(new URL(given, page)));
  return parseRecipe(text, nameOf(given));
}
