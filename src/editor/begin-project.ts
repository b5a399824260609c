import { findMethod, methods } from '../methods/registry.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import { checkGroups, type Recipe, type Resolver } from '../recipe/index.ts';
import type { OpenedFile } from './open-file.ts';
import { type Assets, activeStep, type Project } from './project.ts';
import { startingStep, styleParameter } from './starting-step.ts';
import { type Stack, stackOf } from './steps.ts';

/** What a mesh opens with. */
export interface Beginning {
  /** Default: the style that the mesh before it had, or else the first method. */
  readonly method?: string;
  /** Values that are not to be those that suit the mesh. */
  readonly parameters?: ParameterValues;
  /** A whole stack with its groups, in place of one step of {@link method}. */
  readonly recipe?: Recipe;
  /** The steps of {@link recipe} as they stood when it was saved, with those that were switched off. */
  readonly stack?: Stack;
  /** What the steps name. */
  readonly assets?: Assets;
  /** Where the file was fetched from. */
  readonly address?: string;
}

/**
 * The project that a file begins as, not solved yet.
 *
 * @param last what was done to the mesh before it, if there was one
 * @throws WhittleError as the style that it is to have cannot be read, or groups name vertices that the mesh has not
 */
export async function beginProject(
  file: OpenedFile,
  begin: Beginning,
  last: Project | null,
  resolver: Resolver,
): Promise<Project> {
  const kept = begin.method || begin.recipe ? null : keptStyle(last);
  const method = findMethod(begin.method ?? kept?.method ?? '') ?? methods[0]!;
  const given = { ...kept?.parameters, ...begin.parameters };
  const recipe: Recipe = begin.recipe ?? { steps: [await startingStep(method, given, file, resolver)] };
  const { steps, active } = begin.stack ?? stackOf(recipe);
  const { mesh, report } = file;
  const source = begin.address === undefined ? file.source : { ...file.source, address: begin.address };
  const { groups = [] } = recipe;
  checkGroups(groups, mesh.positions.length / 3);
  const assets: Assets = begin.assets ?? kept?.assets ?? new Map();
  return { source, mesh, report, steps, active, assets, groups };
}

interface KeptStyle {
  readonly method: string;
  readonly parameters: ParameterValues;
  readonly assets: Assets;
}

/** A style is put on the next mesh too; other methods may not suit it. */
function keptStyle(project: Project | null): KeptStyle | null {
  const step = project && activeStep(project);
  const parameter = step && styleParameter(findMethod(step.method));
  const style = parameter && step.parameters[parameter.name];
  if (!parameter || typeof style !== 'string') return null;
  const asset = project.assets.get(style);
  return {
    method: step.method,
    parameters: { [parameter.name]: style },
    assets: asset ? new Map([[style, asset]]) : new Map(),
  };
}
