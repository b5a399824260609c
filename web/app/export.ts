import { activeStep, type Project } from '../../src/editor/project.ts';
import { plainStep, recipeOf } from '../../src/editor/saved-recipe.ts';
import { type FormatInfo, formatInfo } from '../../src/io/index.ts';
import { kebabCase } from '../../src/methods/kebab-case.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { RecipeStep } from '../../src/recipe/index.ts';

/** The format a project goes home in: the one it came in. */
export function ownFormat({ source }: Project): FormatInfo {
  return formatInfo(source.format);
}

/** `rabbit.glb` shaped by `cubic` is `rabbit-cubic.glb`, and by several steps `rabbit-whittled.glb`. @param ending with its dot */
export function exportName(project: Project, ending: string): string {
  const { steps } = recipeOf(project);
  const how = steps.length > 1 ? 'whittled' : (steps[0] ?? activeStep(project)).method;
  return `${stem(project.source.name)}-${how}${ending}`;
}

/** `rabbit.glb` has the recipe `rabbit.whittle.json`. */
export function recipeName({ source }: Project): string {
  return `${stem(source.name)}.whittle.json`;
}

/** The command line that makes the same file without the page; a stack of several steps goes by its recipe. */
export function commandLine(project: Project): string {
  const { source } = project;
  const { steps } = recipeOf(project);
  const out = ['--out', quoted(exportName(project, ownFormat(project).ending))];
  const what =
    steps.length === 1
      ? [steps[0]!.method, quoted(source.name), ...flagsOf(steps[0]!)]
      : ['run', quoted(recipeName(project)), quoted(source.name)];
  return ['npx whittle', ...what, ...out].join(' ');
}

function flagsOf(step: RecipeStep): string[] {
  const { parameters } = plainStep(step);
  const descriptors = findMethod(step.method)?.parameters ?? [];
  return descriptors.flatMap(({ name, kind }) => {
    const value = parameters[name];
    // A style is always named: which it is is the point.
    const said = value ?? (kind === 'style' ? step.parameters[name] : undefined);
    return typeof said === 'object' || said === undefined
      ? []
      : [`--${kebabCase(name)}`, quoted(String(said))];
  });
}

function stem(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'mesh';
}

/** As a POSIX shell reads it. */
function quoted(name: string): string {
  return /^[\w./-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}
