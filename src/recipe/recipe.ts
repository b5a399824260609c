import { type FailureCode, WhittleError } from '../mesh/failure.ts';
import { checkParameters } from '../methods/check.ts';
import { findMethod, methods } from '../methods/registry.ts';
import { didYouMean } from '../methods/suggest.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import { isObject, parseJson } from '../methods/values/json.ts';
import { type Group, parseGroups } from './groups.ts';

/** One run of a method. Each step begins from the shape that the one before left, as its rest shape. */
export interface RecipeStep {
  readonly method: string;
  /** What is absent has its default. */
  readonly parameters: ParameterValues;
}

/** Everything the page can do to a mesh, as saved and as the command line runs it. */
export interface Recipe {
  /** One step or more. */
  readonly steps: readonly RecipeStep[];
  /** Default: none. */
  readonly groups?: readonly Group[];
}

const entries = ['whittle', 'steps', 'groups'];

/** The format's version; a recipe says it as `"whittle": 1`. */
const version = 1;

/**
 * Reads a recipe and holds it against the method descriptors. Whether the vertices that it names exist is known only with the mesh.
 *
 * @param fileName for the messages, which all begin with it
 * @throws WhittleError `bad-recipe` (JSON or shape; element: line or step), `unknown-method`, `bad-parameter`, `bad-handles`,
 * `bad-planes`
 */
export function parseRecipe(text: string, fileName: string): Recipe {
  const recipe = parseJson(text, fileName);
  if (!isObject(recipe) || !('whittle' in recipe)) {
    throw bad(fileName, `a recipe is {"whittle": ${version}, "steps": […]}; the entry “whittle” is missing.`);
  }
  if (recipe.whittle !== version) {
    const found = JSON.stringify(recipe.whittle);
    throw bad(fileName, `this is a recipe of version ${found}; this Whittle reads version ${version}.`);
  }
  const stranger = Object.keys(recipe).find((key) => !entries.includes(key));
  if (stranger !== undefined) {
    throw bad(fileName, `a recipe has no entry “${stranger}”.${didYouMean(stranger, entries)}`);
  }
  if (!Array.isArray(recipe.steps) || recipe.steps.length === 0) {
    throw bad(fileName, '“steps” must be a list of one step or more, such as {"method": "cubic"}.');
  }
  const steps = recipe.steps.map((step, index) => parseStep(step, `${fileName}, step ${index + 1}`, index));
  const groups = parseGroups(recipe.groups, fileName);
  return groups.length > 0 ? { steps, groups } : { steps };
}

/** The recipe as text, one step or group a line, to be read again by {@link parseRecipe}. */
export function formatRecipe({ steps, groups = [] }: Recipe): string {
  const lists = [
    listed(
      'steps',
      steps.map(({ method, parameters }) => ({ method, ...parameters })),
    ),
  ];
  if (groups.length > 0) lists.push(listed('groups', groups));
  return `{\n  "whittle": ${version},\n${lists.join(',\n')}\n}\n`;
}

function listed(name: string, entries: readonly object[]): string {
  const lines = entries.map((entry) => `    ${JSON.stringify(withPlainArrays(entry))}`);
  return `  "${name}": [\n${lines.join(',\n')}\n  ]`;
}

/** The value with lists in place of typed arrays, which JSON has not. As a replacer this would be asked for every single number. */
export function withPlainArrays(value: unknown): unknown {
  if (value instanceof Float64Array) return Array.from(value);
  if (Array.isArray(value)) return typeof value[0] === 'number' ? value : value.map(withPlainArrays);
  if (!isObject(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, withPlainArrays(part)]));
}

function parseStep(step: unknown, place: string, index: number): RecipeStep {
  if (!isObject(step)) throw bad(place, 'a step is an object such as {"method": "cubic"}.', index);
  const { method: id, ...values } = step;
  const ids = methods.map((method) => method.id);
  if (typeof id !== 'string') {
    throw bad(place, `“method” must name a method: ${ids.join(', ')}.`, index);
  }
  const method = findMethod(id);
  if (!method) {
    throw bad(place, `there is no method “${id}”.${didYouMean(id, ids)}`, index, 'unknown-method');
  }
  const problem = checkParameters(method, values);
  if (problem) throw bad(place, problem.message, index, problem.code);
  // Checked just above.
  return { method: id, parameters: values as ParameterValues };
}

function bad(place: string, what: string, element?: number, code: FailureCode = 'bad-recipe'): WhittleError {
  return new WhittleError(code, `${place}: ${what}`, element);
}
