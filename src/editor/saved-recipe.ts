import { findMethod } from '../methods/registry.ts';
import type { ParameterValue, ParameterValues } from '../methods/values/index.ts';
import type { Recipe, RecipeStep } from '../recipe/index.ts';
import type { Project } from './project.ts';

/** The steps of a project that are on, without what has its default anyway: what makes the same shape anywhere else. And its groups. */
export function recipeOf({ steps: all, groups }: Project): Recipe {
  const steps = all.filter(({ isOn }) => isOn).map(plainStep);
  return groups.length > 0 ? { steps, groups } : { steps };
}

/** A step without the values that have their defaults. */
export function plainStep({ method, parameters }: RecipeStep): RecipeStep {
  const kept: Record<string, ParameterValue> = {};
  for (const descriptor of findMethod(method)?.parameters ?? []) {
    const value: ParameterValues[string] | undefined = parameters[descriptor.name];
    const usual = 'default' in descriptor ? descriptor.default : undefined;
    if (value !== undefined && value !== usual) kept[descriptor.name] = value;
  }
  return { method, parameters: kept };
}
