import type { Engine } from '../engine/client.ts';
import { fitsInProject, type ProjectFile } from '../io/index.ts';
import { isObject, parseJson } from '../methods/values/json.ts';
import {
  type Asset,
  fileOfAsset,
  filesNamedBy,
  formatRecipe,
  type Group,
  parseGroups,
  parseRecipe,
  type Recipe,
  type RecipeStep,
  readAsset,
  type Surroundings,
  withFileNames,
  withPlainArrays,
} from '../recipe/index.ts';
import type { Beginning } from './begin-project.ts';
import { freeName } from './free-name.ts';
import type { Project, Step } from './project.ts';
import { plainStep, recipeOf } from './saved-recipe.ts';
import { newStep, type Stack, stackOf, withDefaults } from './steps.ts';

/**
 * What a recipe has no room for, as JSON: the steps that are switched off and what was set for other methods, in the order of the
 * stack. Steps that are on stand in the recipe alone, so that the two cannot say different things.
 */
interface Workspace {
  readonly whittle: 1;
  /** The mesh's file. */
  readonly mesh: string;
  /** As `Source.address`. */
  readonly address?: string;
  /** Which step is edited, from 0. */
  readonly active: number;
  readonly steps: readonly SavedStep[];
  /** Present where no step is on, as there is no recipe then to have them. */
  readonly groups?: readonly Group[];
}

interface SavedStep {
  /** Present where the step is switched off; else it is the recipe's next. */
  readonly off?: object;
  readonly remembered?: readonly object[];
}

/** A project as it leaves memory: texts and bytes. Assets get other names where theirs lead out of a folder. */
export function saveProject(project: Project): ProjectFile {
  const names = new Map<string, string>();
  const assets = new Map<string, Uint8Array<ArrayBuffer>>();
  for (const { name } of filesNamedBy(project.steps.flatMap(allOf))) {
    const asset = project.assets.get(name);
    if (!asset) continue;
    const own = fitsInProject(name)
      ? name
      : freeName(`asset-${name.replace(/^.*[\\/]/, '')}`, (other) => assets.has(other));
    names.set(name, own);
    assets.set(own, fileOfAsset(asset, name));
  }
  const rename = (step: RecipeStep) => withFileNames(step, (name) => names.get(name) ?? name);
  const recipe = recipeOf(project);
  const { source } = project;
  return {
    mesh: { name: source.name, bytes: source.bytes },
    beside: source.beside ?? new Map(),
    assets,
    ...(recipe.steps.length > 0
      ? { recipe: formatRecipe({ ...recipe, steps: recipe.steps.map(rename) }) }
      : {}),
    workspace: `${JSON.stringify(withPlainArrays(workspaceOf(project, rename)), null, 1)}\n`,
  };
}

function workspaceOf(
  { source, steps, active, groups }: Project,
  rename: (step: RecipeStep) => RecipeStep,
): Workspace {
  const flat = (step: RecipeStep) => {
    const { method, parameters } = rename(plainStep(step));
    return { method, ...parameters };
  };
  return {
    whittle: 1,
    mesh: source.name,
    ...(source.address === undefined ? {} : { address: source.address }),
    ...(steps.some(({ isOn }) => isOn) ? {} : { groups }),
    active: steps.findIndex(({ id }) => id === active),
    steps: steps.map((step) => {
      const remembered = rememberedOf(step).map(flat);
      return {
        ...(step.isOn ? {} : { off: flat(step) }),
        ...(remembered.length > 0 ? { remembered } : {}),
      };
    }),
  };
}

/** What else it takes to open a project again. */
export interface Opening {
  readonly engine: Engine;
  readonly decodeImage: NonNullable<Surroundings['decodeImage']>;
}

/**
 * What a saved project's mesh is to begin with.
 *
 * @throws WhittleError for a recipe that is none, and for a file that it names and that cannot be read
 */
export async function beginSaved(saved: ProjectFile, { engine, decodeImage }: Opening): Promise<Beginning> {
  const recipe = saved.recipe === undefined ? null : parseRecipe(saved.recipe, 'recipe.json');
  const workspace = readWorkspace(saved.workspace);
  const stack = (workspace && stackOfWorkspace(workspace, recipe)) ?? (recipe && stackOf(recipe));
  const steps = stack?.steps ?? [];
  const needed = new Set(filesNamedBy(recipe?.steps ?? []).map(({ name }) => name));
  const assets = new Map<string, Asset>();
  for (const file of filesNamedBy(steps.flatMap(allOf))) {
    const bytes = saved.assets.get(file.name);
    if (!bytes) continue;
    try {
      assets.set(file.name, await readAsset(file, bytes, engine, decodeImage));
    } catch (thrown) {
      // What no step needs now is not in the way.
      if (needed.has(file.name)) throw thrown;
    }
  }
  return {
    assets,
    ...(stack ? { stack, recipe: recipe ?? { steps: [], groups: groupsOf(workspace) } } : {}),
    ...(typeof workspace?.address === 'string' ? { address: workspace.address } : {}),
  };
}

/** Null where it is no workspace: the recipe alone has to do. */
function readWorkspace(text: string | undefined): Workspace | null {
  try {
    const workspace = parseJson(text ?? '', 'project.json');
    return isObject(workspace) && Array.isArray(workspace.steps) && workspace.steps.every(isObject)
      ? (workspace as unknown as Workspace)
      : null;
  } catch {
    return null;
  }
}

/** Null where the recipe was changed since and has other steps now. */
function stackOfWorkspace({ steps: saved, active }: Workspace, recipe: Recipe | null): Stack | null {
  const on = [...(recipe?.steps ?? [])];
  const steps: Step[] = [];
  for (const { off, remembered } of saved) {
    const step = off === undefined ? on.shift() : stepOf(off);
    if (!step) return null;
    const others = (Array.isArray(remembered) ? remembered : [])
      .map(stepOf)
      .filter((one) => one !== undefined);
    steps.push({
      ...newStep(withDefaults(step)),
      isOn: off === undefined,
      remembered: Object.fromEntries(others.map(({ method, parameters }) => [method, parameters])),
    });
  }
  const edited = steps[active] ?? steps.at(-1);
  return edited && on.length === 0 ? { steps, active: edited.id } : null;
}

function groupsOf(workspace: Workspace | null): readonly Group[] {
  try {
    return parseGroups(workspace?.groups, 'project.json');
  } catch {
    return [];
  }
}

/** Undefined for what is no step. */
function stepOf(saved: unknown): RecipeStep | undefined {
  try {
    return parseRecipe(JSON.stringify({ whittle: 1, steps: [saved] }), 'project.json').steps[0];
  } catch {
    return undefined;
  }
}

/** A step, and what it would be with the methods that it remembers. */
function allOf(step: Step): readonly RecipeStep[] {
  return [step, ...rememberedOf(step)];
}

function rememberedOf({ remembered }: Step): readonly RecipeStep[] {
  return Object.entries(remembered).map(([method, parameters]) => ({ method, parameters }));
}
