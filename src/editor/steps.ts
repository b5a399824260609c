import { findMethod } from '../methods/registry.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import { checkGroups, type Group, type Recipe, type RecipeStep } from '../recipe/index.ts';
import { type Assets, activeStep, type Project, type Result, type Step } from './project.ts';

/** Changes of the stack, each a new project. What a change makes stale shows by itself: results know what they are of. */

let lastId = 0;

/** A step that was not there before. */
export function newStep({ method, parameters }: RecipeStep): Step {
  return { id: ++lastId, method, parameters, isOn: true, remembered: {}, result: null };
}

/** Steps, and which of them is edited. */
export type Stack = Pick<Project, 'steps' | 'active'>;

/** The steps of a recipe; the last is edited. What it leaves out has its default, so that controls have something to show. */
export function stackOf({ steps: recipe }: Recipe): Stack {
  const steps = recipe.map((step) => newStep(withDefaults(step)));
  return { steps, active: steps.at(-1)!.id };
}

export function withDefaults({ method, parameters }: RecipeStep): RecipeStep {
  const defaults = (findMethod(method)?.parameters ?? []).flatMap((descriptor) =>
    'default' in descriptor && typeof descriptor.default !== 'object'
      ? [[descriptor.name, descriptor.default] as const]
      : [],
  );
  return { method, parameters: { ...Object.fromEntries(defaults), ...parameters } };
}

/**
 * Puts the steps of a recipe in the place of all that there are, and its groups, if it has any.
 *
 * @param assets what the steps name
 * @throws WhittleError where the groups are those of another mesh
 */
export function takeRecipe(project: Project, recipe: Recipe, assets: Assets): Project {
  const { groups = project.groups } = recipe;
  checkGroups(groups, project.mesh.positions.length / 3);
  return { ...project, ...stackOf(recipe), groups, assets: new Map([...project.assets, ...assets]) };
}

/** What is to become of the active step. */
export interface StepChange {
  readonly method?: string;
  readonly parameters?: ParameterValues;
  /** Assets that the new parameters name. */
  readonly assets?: Assets;
  /** The project's groups from now on; default those that it has. */
  readonly groups?: readonly Group[];
}

export function changeActive(project: Project, { method, parameters, assets, groups }: StepChange): Project {
  const step = activeStep(project);
  const changed: Step = {
    ...step,
    method: method ?? step.method,
    parameters: parameters ?? step.parameters,
    // A step that is edited is meant to be seen.
    isOn: true,
    remembered:
      method === undefined || method === step.method
        ? step.remembered
        : { ...step.remembered, [step.method]: step.parameters },
  };
  return withStep(
    {
      ...project,
      assets: assets ? new Map([...project.assets, ...assets]) : project.assets,
      groups: groups ?? project.groups,
    },
    changed,
  );
}

/** The project with another version of one of its steps. */
export function withStep(project: Project, changed: Step): Project {
  return { ...project, steps: project.steps.map((step) => (step.id === changed.id ? changed : step)) };
}

/** The project with a result of its active step; the same where there is none. */
export function withResult(project: Project, result: Result | undefined): Project {
  return result ? withStep(project, { ...activeStep(project), result }) : project;
}

/** Puts a step after the active one and makes it the active one. */
export function addStep(project: Project, step: Step): Project {
  const at = project.steps.findIndex(({ id }) => id === project.active) + 1;
  return { ...project, steps: project.steps.toSpliced(at, 0, step), active: step.id };
}

/** Takes a step out; the one before it, or else after it, is edited next. The last one stays. */
export function removeStep(project: Project, id: number): Project {
  const at = project.steps.findIndex((step) => step.id === id);
  if (at < 0 || project.steps.length === 1) return project;
  const steps = project.steps.toSpliced(at, 1);
  const active = project.active === id ? steps[Math.max(0, at - 1)]!.id : project.active;
  return { ...project, steps, active };
}

/** Moves a step to a place, counted from 0. */
export function moveStep(project: Project, id: number, to: number): Project {
  const at = project.steps.findIndex((step) => step.id === id);
  const place = Math.max(0, Math.min(project.steps.length - 1, to));
  if (at < 0 || at === place) return project;
  return { ...project, steps: project.steps.toSpliced(at, 1).toSpliced(place, 0, project.steps[at]!) };
}

export function switchStep(project: Project, id: number, isOn: boolean): Project {
  const step = project.steps.find((one) => one.id === id);
  return step && step.isOn !== isOn ? withStep(project, { ...step, isOn }) : project;
}

export function activateStep(project: Project, id: number): Project {
  return project.active === id || !project.steps.some((step) => step.id === id)
    ? project
    : { ...project, active: id };
}
